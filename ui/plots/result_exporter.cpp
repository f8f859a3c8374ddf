#include "ui/plots/result_exporter.h"

#include <QCoreApplication>

#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace cullscope::ui {

void ResultExporter::write(const std::filesystem::path& path, Contents contents) {
    // A Background knows one piece of work at a time; each file is its own.
    auto* background = new Background(this);
    background->start([this, background, path, contents = std::move(contents)](const std::stop_token&) -> Background::Delivery {
        return [deliver = run(path, contents), background] {
            background->deleteLater();
            deliver();
        };
    });
}

Background::Delivery ResultExporter::run(const std::filesystem::path& path, const Contents& contents) {
    try {
        const QByteArray bytes = contents();
        writeFileAtomically(path, [&](std::ostream& out) { out.write(bytes.constData(), bytes.size()); });
        return [this, path] { emit written(QString::fromStdString(path.string())); };
    } catch (const Error& error) {
        return [this, message = error.message()] { emit failed(message); };
    } catch (const std::exception& error) {
        const Message message{QT_TRANSLATE_NOOP("core", "%1 cannot be written: %2. Choose another place or free some space."),
                              {path.string(), error.what()}};
        return [this, message] { emit failed(message); };
    }
}

}  // namespace cullscope::ui
