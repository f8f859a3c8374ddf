#include "ui/session/recent_files.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace cullscope::ui::recent_files_test {
namespace {

struct Recent : ::testing::Test {
    void SetUp() override { QSettings().clear(); }

    QString file(const char* name) {
        QFile made(folder.filePath(QLatin1String(name)));
        EXPECT_TRUE(made.open(QIODevice::WriteOnly));
        return made.fileName();
    }

    QTemporaryDir folder;
};

TEST_F(Recent, theNewestComesFirstOnceAndTheEleventhGoes) {
    RecentFiles recent;
    for (int i = 0; i < 12; ++i) recent.add(QStringLiteral("sphere:triangles=%1").arg(i));
    EXPECT_EQ(recent.entries().size(), 10);
    EXPECT_EQ(recent.entries().first(), QStringLiteral("sphere:triangles=11"));
    EXPECT_EQ(recent.entries().last(), QStringLiteral("sphere:triangles=2"));
    recent.add(QStringLiteral("sphere:triangles=5"));
    EXPECT_EQ(recent.entries().size(), 10);
    EXPECT_EQ(recent.entries().first(), QStringLiteral("sphere:triangles=5"));
    EXPECT_EQ(recent.entries().count(QStringLiteral("sphere:triangles=5")), 1);
}

TEST_F(Recent, theListOutlivesTheProgram) {
    const QString mesh = file("성, a=b.ply");
    RecentFiles().add(mesh);
    EXPECT_EQ(RecentFiles().entries(), QStringList{mesh});
    RecentFiles().clear();
    EXPECT_TRUE(RecentFiles().entries().isEmpty());
}

TEST_F(Recent, relativeFilesAreKeptWithTheirFolder) {
    RecentFiles recent;
    recent.add(QStringLiteral("sub/../castle.obj"));
    recent.add(QStringLiteral("field:mesh=castle.obj,n=3"));
    const QString castle = QDir::currentPath() + QStringLiteral("/castle.obj");
    EXPECT_EQ(recent.entries(), (QStringList{QStringLiteral("field:mesh=%1,n=3").arg(castle), castle}));
}

TEST_F(Recent, whatIsGoneLeavesTheList) {
    RecentFiles recent;
    const QString mesh = file("a.ply");
    const QString field = QStringLiteral("field:mesh=%1,n=3").arg(mesh);
    for (const QString& each : {QStringLiteral("bunny"), mesh, field}) recent.add(each);
    for (const QString& each : recent.entries()) EXPECT_TRUE(recent.keepIfThere(each)) << each.toStdString();
    QSignalSpy changed(&recent, &RecentFiles::changed);
    QFile::remove(mesh);
    EXPECT_FALSE(recent.keepIfThere(mesh));
    EXPECT_FALSE(recent.keepIfThere(field));
    EXPECT_TRUE(recent.keepIfThere(QStringLiteral("bunny")));
    EXPECT_EQ(changed.count(), 2);
    EXPECT_EQ(recent.entries(), QStringList{QStringLiteral("bunny")});
    EXPECT_EQ(RecentFiles().entries(), QStringList{QStringLiteral("bunny")});
    EXPECT_EQ(RecentFiles::goneMessage(mesh).english(),
              mesh.toStdString() + " is not there any more; it was taken off the list of recent files.");
}

TEST_F(Recent, aDamagedListIsAnEmptyOne) {
    QSettings().setValue(QStringLiteral("recent"), QByteArray("\x01\x02", 2));
    EXPECT_LE(RecentFiles().entries().size(), 1);
    QSettings().setValue(QStringLiteral("recent"), QVariantMap{{QStringLiteral("a"), 1}});
    EXPECT_TRUE(RecentFiles().entries().isEmpty());
    QSettings().setValue(QStringLiteral("recent"), QStringList{QString(), QString()});
    EXPECT_TRUE(RecentFiles().entries().isEmpty());
}

}  // namespace
}  // namespace cullscope::ui::recent_files_test
