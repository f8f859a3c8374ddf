#include "ui/plots/result_exporter.h"

#include <QCoreApplication>

#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace cullscope::ui {

void ResultExporter::write(const std::filesystem::path& path, Contents contents) {
    // A Background knows one piece of work at a time; each file is its own.
    auto* background = new Background(this);
    const auto work = [this, background, path, contents = std::move(contents)](const std::stop_token&) -> Background::Delivery {
        const QByteArray bytes = contents();
        writeFileAtomically(path, [&](std::ostream& out) { out.write(bytes.constData(), bytes.size()); });
        return [this, background, path] {
            background->deleteLater();
            emit written(QString::fromStdString(path.string()));
        };
    };
    background->start(work, [this, background, path](const std::exception& error) -> Background::Delivery {
        Message message{QT_TRANSLATE_NOOP("core", "%1 cannot be written: %2. Choose another place or free some space."),
                        {path.string(), error.what()}};
        if (const auto* known = dynamic_cast<const Error*>(&error)) message = known->message();
        return [this, background, message] {
            background->deleteLater();
            emit failed(message);
        };
    });
}

}  // namespace cullscope::ui
