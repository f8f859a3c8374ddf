// Commands that the menus of the window and of views have, beside those that have a file of tests of their own.
#include <QLineEdit>
#include <QMessageBox>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTimer>

#include "tests/ui/shown_window.h"
#include "ui/dialogs/generate_dialog.h"
#include "ui/session/object_pick.h"

namespace cullscope::ui::desk_commands_test {
namespace {

QAction* actionOf(const QList<QAction*>& actions, const QString& text) {
    for (QAction* action : actions)
        if (action->text() == text) return action;
    return nullptr;
}

TEST_F(Window, undoAfterAParameterWorksFromItsField) {
    session.setActiveView(0);
    session.slot(0).choose("spherical");
    window.side().setOpenPage(0);
    settle();
    auto* box = window.strategyPanel().form().findChild<QWidget*>(QStringLiteral("rows"))->findChild<QSpinBox*>();
    ASSERT_TRUE(box);
    ASSERT_TRUE(waitUntil([&] { return !window.document().undo().undoText().endsWith(QLatin1String("Undo")); }));
    // Shortcuts are those of the active window.
    ASSERT_TRUE(waitUntil([&] {
        window.activateWindow();
        return window.isActiveWindow();
    }));
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, QStringLiteral("90"));
    const int64_t chosen = session.slot(0).parameters().integer("rows");
    ASSERT_NE(chosen, 180) << box->value() << " in the field of " << window.strategyPanel().title().toStdString();
    ASSERT_TRUE(waitUntil([&] { return window.document().undo().undoText() == QStringLiteral("Undo: parameters of view A"); }));
    QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(session.slot(0).parameters().integer("rows"), 180) << "the window's step, and not letters of the field";
    // The fields are made anew, and the former ones are deleted later.
    EXPECT_TRUE(waitUntil([&] {
        auto* field = window.strategyPanel().form().findChild<QWidget*>(QStringLiteral("rows"));
        return field && field->findChild<QSpinBox*>()->value() == 180;
    }));
    window.actions().redo->trigger();
    EXPECT_EQ(session.slot(0).parameters().integer("rows"), chosen);
}

TEST_F(Window, aSavedFileIsConfirmedWithItsFolder) {
    const QTemporaryDir folder;
    QStringList opened;
    window.message().setFolderOpener([&](const QString& path) { opened << path; });
    const QString file = folder.filePath(QStringLiteral("a.cullscope"));
    session.tellSaved(file);
    ASSERT_TRUE(window.message().isVisible());
    EXPECT_TRUE(window.message().text().contains(file));
    ASSERT_TRUE(window.message().offered().isVisible());
    QTest::mouseClick(&window.message().offered(), Qt::LeftButton);
    EXPECT_EQ(opened, QStringList{folder.path()});
    EXPECT_FALSE(window.message().isVisible());
}

TEST_F(Window, anObjectOfThePictureIsHiddenIsolatedAndFramedByItsMenu) {
    openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=320,n=3,spacing=2.5"));
    settle();
    const SceneView& view = picture(0);
    // The middle of the picture shows the object in the middle, or one before it.
    const Vec2 middle = view.pixelAt(QPointF(view.width() / 2.0, view.height() / 2.0));
    const std::optional<uint32_t> object = session.objectAt(0, int(middle.x), int(middle.y));
    ASSERT_TRUE(object);
    EXPECT_FALSE(session.objectAt(0, 0, view.renderSize().height - 1)) << "the background";
    isolateObjects(session, {*object});
    EXPECT_EQ(std::ranges::count(session.hidden(), false), 1);
    EXPECT_FALSE(session.hidden()[*object]);
    showAllObjects(session);
    EXPECT_EQ(std::ranges::count(session.hidden(), true), 0);
    setObjectsHidden(session, {*object}, true);
    settle();
    EXPECT_NE(session.objectAt(0, int(middle.x), int(middle.y)), object) << "what lies behind it";
    showAllObjects(session);
    settle();
    // The same by a click with the right button.
    const QString name = QString::fromStdString(session.opened()->scene->instances()[*object].name);
    bool found = false;
    QTimer::singleShot(0, &window, [&] {
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        ASSERT_TRUE(menu);
        QAction* of = menu->actions().front();
        EXPECT_EQ(of->text(), QStringLiteral("Object ") + name);
        ASSERT_TRUE(of->menu());
        if (QAction* hide = actionOf(of->menu()->actions(), QStringLiteral("Hide"))) {
            found = true;
            hide->trigger();
        }
        menu->close();
    });
    QTest::mouseClick(&picture(0), Qt::RightButton, {}, QPoint(view.width() / 2, view.height() / 2));
    ASSERT_TRUE(found);
    EXPECT_TRUE(session.hidden()[*object]);
}

TEST_F(Window, theDistanceBetweenTwoPicksIsSaid) {
    session.setPick(pickOfTriangle(session, 0, 0));
    const Vec3 first = session.pick()->point;
    EXPECT_FALSE(session.pointBefore());
    session.setPick(pickOfTriangle(session, 0, 700));
    ASSERT_TRUE(session.pointBefore());
    EXPECT_EQ(*session.pointBefore(), first);
    const QString length = QLocale().toString(glm::length(session.pick()->point - first), 'g', 4);
    bool said = false;
    for (const auto* label : window.findChildren<QLabel*>())
        said = said || label->text().contains(length + QStringLiteral(" from the point picked before"));
    EXPECT_TRUE(said) << length.toStdString();
    session.setPick(std::nullopt);
    EXPECT_FALSE(session.pointBefore()) << "a click beside the model ends it";
}

TEST_F(Window, camerasAreKeptByName) {
    QMenu& menu = *window.actions().bookmarks;
    ASSERT_TRUE(actionOf(menu.actions(), QStringLiteral("Keep as camera 2")));
    std::string said;
    QObject::connect(&session, &Session::messageRaised, &menu,
                     [&](Severity, const Message& message) { said = message.english(); });
    actionOf(menu.actions(), QStringLiteral("Keep as camera 2"))->trigger();
    EXPECT_EQ(said, "Kept as camera 2. Alt+2 goes back to it.");
    const Camera kept = session.camera();
    ASSERT_TRUE(waitUntil([&] { return actionOf(menu.actions(), QStringLiteral("Go to camera 2"))->isEnabled(); }));
    QTimer::singleShot(0, &window, [] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        ASSERT_TRUE(dialog);
        dialog->findChild<QLineEdit*>()->setText(QStringLiteral(" entrance & stairs "));
        dialog->accept();
    });
    QMenu* names = nullptr;
    for (QAction* action : menu.actions())
        if (action->menu()) names = action->menu();
    ASSERT_TRUE(names);
    EXPECT_FALSE(names->actions().front()->isEnabled()) << "camera 1 is not kept";
    names->actions()[1]->trigger();
    const QString text = QStringLiteral("Go to camera 2: entrance && stairs");
    ASSERT_TRUE(waitUntil([&] { return actionOf(menu.actions(), text) != nullptr; }));
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(40.0), {}));
    actionOf(menu.actions(), text)->trigger();
    EXPECT_EQ(session.camera(), kept);
}

TEST_F(Window, builtInPathsAreNamedInTheLanguageOfTheWindow) {
    for (const Language::Known& known : Language::known()) {
        language.use(known.id);
        const QList<QAction*> paths = window.actions().builtInPaths->actions();
        ASSERT_EQ(size_t(paths.size()), builtInPaths().size());
        for (const QAction* path : paths) {
            EXPECT_EQ(path->text().count(QLatin1Char('\t')), 1) << path->text().toStdString();
            EXPECT_FALSE(path->text().contains(QRegularExpression(QStringLiteral("\\bN\\b")))) << path->text().toStdString();
        }
    }
    language.use(QStringLiteral("en"));
    EXPECT_EQ(window.actions().builtInPaths->actions().front()->text(),
              QStringLiteral("16 poses on a circle at three times the scene's radius, 15 degrees above it\torbit:16"));
}

TEST_F(Window, aWireframeSaysWhoseFiguresStand) {
    session.setActiveView(0);
    const ViewMetrics before = session.figures(0);
    window.actions().show("wireframe")->trigger();
    settle();
    EXPECT_TRUE(window.views().pane(0).chipText().contains(QStringLiteral("wireframe")))
        << window.views().pane(0).chipText().toStdString() << session.setup(0).look.shows("wireframe");
    EXPECT_EQ(session.figures(0).accuracy.missedPixels, before.accuracy.missedPixels);
    EXPECT_EQ(session.figures(0).accuracy.coveredPixels, before.accuracy.coveredPixels);
    EXPECT_EQ(session.figures(0).submitted.triangles, before.submitted.triangles);
}

const GeneratorInfo& generator(const std::string& id) { return *std::ranges::find(sceneGenerators(), id, &GeneratorInfo::id); }

TEST(GenerateDialog, saysHowLargeTheSceneWillBeAndAsksBeforeALargeOne) {
    GenerateDialog dialog(generator("sphere"));
    auto* field = dialog.findChild<QLineEdit*>();
    EXPECT_TRUE(dialog.sizeSentence().contains(QStringLiteral("100,000"))) << dialog.sizeSentence().toStdString();
    field->setText(QStringLiteral("many"));
    EXPECT_TRUE(dialog.sizeSentence().contains(QStringLiteral("triangles"))) << dialog.sizeSentence().toStdString();
    EXPECT_FALSE(dialog.canGenerate()) << "a wrong value is mended in the dialog, which would be gone";
    field->setText(QStringLiteral("5e7"));
    EXPECT_TRUE(dialog.sizeSentence().contains(QStringLiteral("50,000,000"))) << dialog.sizeSentence().toStdString();
    EXPECT_TRUE(dialog.canGenerate());
    int asked = 0;
    const auto answer = [&](QMessageBox::ButtonRole role) {
        QTimer::singleShot(0, &dialog, [&asked, role] {
            auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            ASSERT_TRUE(question);
            ++asked;
            for (QAbstractButton* button : question->buttons())
                if (question->buttonRole(button) == role) return button->click();
        });
        dialog.accept();
    };
    dialog.show();
    answer(QMessageBox::RejectRole);
    EXPECT_NE(dialog.result(), QDialog::Accepted);
    answer(QMessageBox::AcceptRole);
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    EXPECT_EQ(asked, 2);
    field->setText(QStringLiteral("1e4"));
    dialog.accept();
    EXPECT_EQ(asked, 2) << "a small scene is made at once";
}

}  // namespace
}  // namespace cullscope::ui::desk_commands_test
