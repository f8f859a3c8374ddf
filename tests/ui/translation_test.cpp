// The catalogues are complete: they translate exactly the texts that lupdate finds in the present sources.
#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QGlyphRun>
#include <QProcess>
#include <QRawFont>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTextLayout>
#include <QTranslator>
#include <QXmlStreamReader>
#include <cerrno>

#include "core/base/error.h"
#include "ui/text/language.h"
#include "ui/text/letters.h"
#include "ui/text/translated.h"

namespace cullscope::ui::translation_test {
namespace {

struct Entry {
    QString context, source, comment, translation;
    bool unfinished = false;
};

QList<Entry> readCatalogue(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    QXmlStreamReader xml(&file);
    QList<Entry> entries;
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("name")) context = xml.readElementText();
        if (xml.name() == QLatin1String("message")) entries.push_back({context, {}, {}, {}, false});
        if (xml.name() == QLatin1String("source")) entries.back().source = xml.readElementText();
        if (xml.name() == QLatin1String("comment")) entries.back().comment = xml.readElementText();
        if (xml.name() == QLatin1String("translation")) {
            entries.back().unfinished = xml.attributes().hasAttribute(QLatin1String("type"));
            entries.back().translation = xml.readElementText(QXmlStreamReader::IncludeChildElements);
        }
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return entries;
}

QSet<QString> keys(const QList<Entry>& entries) {
    QSet<QString> result;
    for (const Entry& entry : entries)
        result.insert(entry.context + QLatin1Char('|') + entry.source + QLatin1Char('|') + entry.comment);
    return result;
}

QSet<QString> places(const QString& text) {
    static const QRegularExpression place(QStringLiteral("%[1-9]"));
    QSet<QString> result;
    for (auto match = place.globalMatch(text); match.hasNext();) result.insert(match.next().captured());
    return result;
}

QString catalogue(const char* language) {
    return QStringLiteral(CULLSCOPE_SOURCE_DIR "/resources/translations/cullscope_%1.ts").arg(QLatin1String(language));
}

TEST(Translation, nothingIsUnfinishedAndEveryPlaceIsKept) {
    for (const char* language : {"ko", "zh_CN"}) {
        const QList<Entry> entries = readCatalogue(catalogue(language));
        EXPECT_GT(entries.size(), 200);
        for (const Entry& entry : entries) {
            const std::string where = std::string(language) + ": " + entry.source.toStdString();
            EXPECT_FALSE(entry.unfinished) << where;
            EXPECT_FALSE(entry.translation.isEmpty()) << where;
            EXPECT_EQ(places(entry.source), places(entry.translation)) << where;
        }
    }
}

TEST(Translation, everySentenceInTheSourcesIsInTheCatalogues) {
    const QTemporaryDir folder;
    const QString fresh = folder.filePath(QStringLiteral("fresh_ko.ts"));
    QProcess update;
    update.start(QStringLiteral(CULLSCOPE_SOURCE_DIR "/resources/translations/update.sh"),
                 {QStringLiteral(CULLSCOPE_LUPDATE), QStringLiteral(CULLSCOPE_SOURCE_DIR), folder.path(), fresh});
    ASSERT_TRUE(update.waitForFinished(60'000));
    ASSERT_EQ(update.exitCode(), 0) << update.readAllStandardError().toStdString();
    const QSet<QString> wanted = keys(readCatalogue(fresh));
    for (const char* language : {"ko", "zh_CN"}) {
        const QSet<QString> known = keys(readCatalogue(catalogue(language)));
        for (const QString& missing : wanted - known)
            ADD_FAILURE() << language << " lacks: " << missing.toStdString() << " (build update_translations, then translate)";
        for (const QString& gone : known - wanted) ADD_FAILURE() << language << " keeps what is gone: " << gone.toStdString();
    }
    // All sentences of core are in the contexts in which the desktop looks them up.
    for (const QString& key : wanted) {
        const QString context = key.section(QLatin1Char('|'), 0, 0);
        EXPECT_TRUE(context == QLatin1String("core") || context == QLatin1String("Wording") ||
                    context == QLatin1String("ViewMenu") || context == QLatin1String("HtmlReport") ||
                    context == QLatin1String("Screenshot") || context == QLatin1String("SphericalModel") ||
                    context.startsWith(QLatin1String("cullscope::ui::")))
            << context.toStdString();
    }
}

TEST(Translation, cataloguesTravelInTheProgram) {
    for (const Language::Known& language : Language::known()) {
        if (language.id == QStringLiteral("en")) continue;
        EXPECT_TRUE(QFile::exists(QStringLiteral(":/i18n/cullscope_%1.qm").arg(language.id)));
    }
}

/// A translator that puts every text of core that it knows into angle brackets.
class Bracketing : public QTranslator {
public:
    Bracketing() { QCoreApplication::installTranslator(this); }
    ~Bracketing() override { QCoreApplication::removeTranslator(this); }

    QString translate(const char* context, const char* source, const char* /*comment*/, int /*number*/) const override {
        static const QSet<QString> known{QStringLiteral("%1 cannot be written: %2."), QStringLiteral("no space is left"),
                                         QStringLiteral("hidden")};
        const QString text = QString::fromUtf8(source);
        return QLatin1String(context) == QLatin1String(kCoreContext) && known.contains(text) ? QStringLiteral("<%1>").arg(text)
                                                                                             : QString();
    }
    bool isEmpty() const override { return false; }
};

/// The families whose glyphs write a character in a font.
QStringList familiesOf(const QString& character, const QFont& font) {
    QTextLayout layout(character, font);
    layout.beginLayout();
    layout.createLine();
    layout.endLayout();
    QStringList families;
    for (const QGlyphRun& run : layout.glyphRuns()) families << run.rawFont().familyName();
    return families;
}

TEST(Translation, chineseTextHasTheCharactersOfChinaAndLatinLettersStay) {
    const QString family = QStringLiteral("Noto Sans CJK SC");
    if (!QFontDatabase::families().contains(family)) GTEST_SKIP() << "The package fonts-noto-cjk is not installed.";
    const QString latin = familiesOf(QStringLiteral("a"), QApplication::font()).join(QString());
    const QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    {
        Language language;
        language.use(QStringLiteral("zh_CN"));
        // In Japan this one has another stroke.
        EXPECT_EQ(familiesOf(QStringLiteral("直"), QApplication::font()), QStringList(family));
        EXPECT_TRUE(familiesOf(QStringLiteral("直"), lettersOf(QLocale(), fixed)).first().endsWith(QLatin1String(" SC")));
        EXPECT_EQ(familiesOf(QStringLiteral("a"), QApplication::font()), QStringList(latin));
        QFont large;
        large.setPixelSize(20);
        EXPECT_EQ(familiesOf(QStringLiteral("直"), large), QStringList(family));
    }
    EXPECT_EQ(QApplication::font().families().contains(family), false) << "the next language has its own letters";
}

TEST(Translation, reasonInAnArgumentIsTranslatedAndANameIsNot) {
    const Bracketing catalogue;
    const auto shown = [](std::string name, std::string reason) {
        return translated(Message{"%1 cannot be written: %2.", {std::move(name), std::move(reason)}});
    };
    EXPECT_EQ(shown("a.png", systemReason(ENOSPC)), QStringLiteral("<a.png cannot be written: <no space is left>.>"));
    EXPECT_EQ(shown("hidden", ""), QStringLiteral("<hidden cannot be written: .>")) << "a file of that name";
    EXPECT_EQ(shown("no space is left.png", "그림 %1"), QStringLiteral("<no space is left.png cannot be written: 그림 %1.>"));
}

}  // namespace
}  // namespace cullscope::ui::translation_test
