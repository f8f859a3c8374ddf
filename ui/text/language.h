#pragma once

#include <QList>
#include <QObject>
#include <QString>
#include <QTranslator>

namespace cullscope::ui {

/// The languages of the program and switching between them while it runs: widgets get QEvent::LanguageChange.
class Language : public QObject {
    Q_OBJECT

public:
    struct Known {
        QString id;          ///< "en", "ko", "zh_CN": on the command line and in the settings
        QString nativeName;  ///< never translated
    };
    [[nodiscard]] static const QList<Known>& known();
    [[nodiscard]] static bool isKnown(const QString& id);
    /// What the system is set to, or English.
    [[nodiscard]] static QString ofSystem();

    explicit Language(QObject* parent = nullptr) : QObject(parent) {}
    ~Language() override;

    [[nodiscard]] const QString& current() const { return m_current; }
    /// Loads the program's own catalogue and Qt's.
    void use(const QString& id);

signals:
    void changed();

private:
    QString m_current = QStringLiteral("en");
    QTranslator m_program;
    QTranslator m_qt;
};

}  // namespace cullscope::ui
