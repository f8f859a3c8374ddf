#include "ui/text/language.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>

#include "ui/text/letters.h"

namespace cullscope::ui {

const QList<Language::Known>& Language::known() {
    static const QList<Known> languages{{QStringLiteral("en"), QStringLiteral("English")},
                                        {QStringLiteral("ko"), QStringLiteral("한국어")},
                                        {QStringLiteral("zh_CN"), QStringLiteral("简体中文")}};
    return languages;
}

bool Language::isKnown(const QString& id) {
    return std::any_of(known().begin(), known().end(), [&](const Known& language) { return language.id == id; });
}

QString Language::ofSystem() {
    switch (QLocale::system().language()) {
        case QLocale::Korean:
            return QStringLiteral("ko");
        case QLocale::Chinese:
            return QStringLiteral("zh_CN");
        default:
            return QStringLiteral("en");
    }
}

Language::~Language() {
    QCoreApplication::removeTranslator(&m_program);
    QCoreApplication::removeTranslator(&m_qt);
    if (m_plain) QApplication::setFont(*m_plain);
}

void Language::use(const QString& id) {
    if (!isKnown(id) || id == m_current) return;
    m_current = id;
    QCoreApplication::removeTranslator(&m_program);
    QCoreApplication::removeTranslator(&m_qt);
    QLocale::setDefault(QLocale(id));
    if (id != QStringLiteral("en")) {
        if (m_qt.load(QStringLiteral("qtbase_") + id, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
            QCoreApplication::installTranslator(&m_qt);
        if (m_program.load(QStringLiteral(":/i18n/cullscope_") + id)) QCoreApplication::installTranslator(&m_program);
    }
    setLetters();
    emit changed();
}

void Language::setLetters() {
    const QFont plain = m_plain.value_or(QApplication::font());
    const QFont letters = lettersOf(QLocale(m_current), plain);
    if (letters == QApplication::font()) return;
    m_plain = plain;
    QApplication::setFont(letters);
}

}  // namespace cullscope::ui
