#pragma once

#include <QFont>
#include <QList>
#include <QObject>
#include <QString>
#include <QTranslator>
#include <optional>

namespace cullscope::ui {

/// The languages of the program, and switching between them at run time: widgets receive QEvent::LanguageChange.
class Language : public QObject {
    Q_OBJECT

public:
    struct Known {
        QString id;          ///< "en", "ko", "zh_CN": name on the command line and in the settings
        QString nativeName;  ///< never translated
    };
    [[nodiscard]] static const QList<Known>& known();
    [[nodiscard]] static bool isKnown(const QString& id);
    /// The id of the system's language, or "en".
    [[nodiscard]] static QString ofSystem();

    explicit Language(QObject* parent = nullptr) : QObject(parent) {}
    ~Language() override;

    [[nodiscard]] const QString& current() const { return m_current; }
    /// Loads the catalogues of the program and of Qt for a language, and has the application write its characters.
    void use(const QString& id);

signals:
    void changed();

private:
    void setLetters();

    QString m_current = QStringLiteral("en");
    QTranslator m_program;
    QTranslator m_qt;
    std::optional<QFont> m_plain;  ///< the application's font where a language took another
};

}  // namespace cullscope::ui
