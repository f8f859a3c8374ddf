// What the commands are called, in the language of the window.
#include "ui/window/window_actions.h"

#include <QRegularExpression>
#include <algorithm>

#include "core/scene/camera_path.h"
#include "core/scene/scene_source.h"
#include "core/visibility/registry.h"
#include "ui/look/tinted_icon.h"
#include "ui/session/named_views.h"
#include "ui/text/language.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

/// A menu text as a toolbar shows it: without the mnemonic, which Korean and Chinese put in parentheses.
QString withoutMnemonic(QString text) {
    static const QRegularExpression inParentheses(QStringLiteral("\\(&.\\)"));
    return text.remove(inParentheses).remove(QLatin1Char('&')).remove(QChar(u'…'));
}

/// Sets an action's text; its tooltip names the shortcut.
void say(QAction* action, const QString& text, const QString& tip) {
    action->setText(text);
    action->setIconText(withoutMnemonic(text));
    action->setToolTip(action->shortcut().isEmpty()
                           ? tip
                           : QStringLiteral("%1 (%2)").arg(tip, action->shortcut().toString(QKeySequence::NativeText)));
}

}  // namespace

void WindowActions::retranslate() {
    m_fileMenu->setTitle(tr("&File"));
    m_editMenu->setTitle(tr("&Edit"));
    m_viewMenu->setTitle(tr("&View"));
    m_pictureMenu->setTitle(tr("&Picture"));
    m_pathMenu->setTitle(tr("P&ath"));
    // The English word stays beside the translation, so that the user finds the menu in any language.
    m_languageMenu->setTitle(tr("&Language"));
    m_helpMenu->setTitle(tr("&Help"));
    retranslateFile();
    retranslateView();
    retranslatePicture();
    say(keys, tr("Mouse and &keys"), tr("Show all mouse moves and keys"));
    say(help, tr("&Help"), tr("What the views, panels and figures mean"));
    say(about, tr("&About Cullscope"), tr("Version and licences"));
    fillGenerate();
    fillPaths();
    fillLookFrom();
}

void WindowActions::retranslateFile() {
    generate->setTitle(tr("&Generate"));
    generate->menuAction()->setIconText(withoutMnemonic(generate->title()));
    generate->setIcon(tintedIcon(QStringLiteral("generate")));
    recent->setTitle(tr("Open &recent"));
    lessons->setTitle(tr("&Lessons"));
    say(openLesson, tr("&Open a lesson…"), tr("Open a lesson's file"));
    say(addLessonStep, tr("&Add as step…"), tr("Add what the window shows to a lesson of your own"));
    say(handout, tr("&Handout…"), tr("Save all steps of the lesson as a PDF or HTML file: picture, sentence and figures"));
    say(lessonOn, tr("Next step"), tr("Go on to the lesson's next step"));
    say(lessonBack, tr("Step before"), tr("Go back to the lesson's step before"));
    say(lessonFirst, tr("First step"), tr("Go to the lesson's first step"));
    say(lessonLast, tr("Last step"), tr("Go to the lesson's last step"));
    say(leaveLesson, tr("&Leave the lesson"), tr("Leave the lesson: what is shown stays"));
    say(open, tr("&Open…"), tr("Open a mesh file, a session, or a picture that Cullscope took"));
    say(saveSession, tr("&Save the session"), tr("Save scene, views, strategies and cameras as a file"));
    say(saveSessionAs, tr("Save the session &as…"), tr("Save the session under another name"));
    say(screenshot, tr("S&creenshot…"), tr("Save a picture of the views: size, format, legend, background"));
    say(screenshotNow, tr("Screenshot a&gain"), tr("Save a picture as the last time"));
    say(screenshotBare, tr("Screenshot &without overlays"), tr("Save a picture of what was drawn and nothing over it"));
    say(quit, tr("&Quit"), tr("Leave the program"));
}

void WindowActions::retranslateView() {
    m_upMenu->setTitle(tr("&Up axis"));
    m_appearanceMenu->setTitle(tr("&Appearance"));
    bookmarks->setTitle(tr("Camera &bookmarks"));
    lookFrom->setTitle(tr("Look &from"));
    m_projectionMenu->setTitle(tr("Pro&jection"));
    say(perspective, tr("&Perspective"), tr("Lines of sight meet in the eye: what is farther is smaller"));
    say(parallel, tr("P&arallel"), tr("Lines of sight run side by side: sizes do not depend on the distance (orthographic)"));
    say(clippingPlane, tr("Clippin&g plane…"), tr("Cut the pictures by a plane, to look inside: a section"));
    pictureSize->setTitle(tr("Picture si&ze"));
    panels->setTitle(tr("&Panels"));
    say(oneView, tr("&1 view"), tr("Show one view"));
    say(twoViews, tr("&2 views"), tr("Show two views beside each other"));
    say(fourViews, tr("&4 views"), tr("Compare four views"));
    say(sixViews, tr("&6 views"), tr("Compare six views: three columns"));
    say(eightViews, tr("&8 views"), tr("Compare eight views"));
    say(home, tr("&Home"), tr("Back to the first view of the scene"));
    say(frame, tr("&Frame the scene"), tr("Show the whole scene from the present direction"));
    say(upY, tr("&y up"), tr("The y axis points up"));
    say(upZ, tr("&z up"), tr("The z axis points up"));
    say(lecture, tr("&Lecture"), tr("Show the active view full screen, large enough for the back row"));
    say(stepThrough, tr("S&tep through"), tr("Replay the active view's frame step by step, with what the strategy decides"));
    say(questionFirst, tr("&Question first"),
        tr("Hide figures and verdicts until what the audience expects was clicked, then reveal both beside each other"));
    say(stepOn, tr("One step on"), {});
    say(stepBack, tr("One step back"), {});
    say(stepFirst, tr("To the first step"), {});
    say(stepLast, tr("To the last step"), {});
    say(stepToBreakpoint, tr("On to the next breakpoint"), {});
    say(stepBackToBreakpoint, tr("Back to the last breakpoint"), {});
    say(reproduce, tr("Repro&duce a paper's table…"),
        tr("Measure what a paper's table shows, in the paper's windows, and put its numbers beside ours"));
    say(figures, tr("Dra&w a paper's figure…"), tr("Draw a figure of a paper anew, and save it as a picture or as its numbers"));
    say(stability, tr("Sta&bility…"), tr("Run the battery of extreme cases, and open their scenes"));
    say(advise, tr("Adv&ise…"), tr("Measure which strategy suits this scene, what it would lose, and what it costs"));
    say(reports, tr("&Kept reports…"), tr("The advice, worst views, runs of the battery and certificates of the result store"));
    say(worst, tr("W&orst view…"), tr("Search for the view in which the active view's strategy loses most or gains least"));
    say(resetLayout, tr("&Reset the layout"), tr("Put all panels back to their places"));
    say(systemAppearance, tr("As the &system"), tr("Light or dark as the system is set"));
    say(lightAppearance, tr("&Light"), tr("Dark on light"));
    say(darkAppearance, tr("&Dark"), tr("Light on dark"));
}

void WindowActions::retranslatePicture() {
    say(freeze, tr("&Freeze culling"), tr("The culling camera stands while you fly on in the active view"));
    say(watch, tr("&Watch from outside"), tr("Another view shows from outside what the active view culls; again: it is linked"));
    for (const auto& [show, action] : shows) say(action, translated(show->action), translated(show->explanation));
    say(truth, tr("Wipe: &truth | strategy"), tr("Put the truth beside the strategy's picture; drag the line"));
    say(loss, tr("&Missed pixels"), tr("Mark the pixels that the strategy missed or added"));
    say(nextLoss, tr("&Next loss"), tr("Go to the next lost pixels, largest hole first"));
    say(axes, tr("A&xes"), tr("Show the axes in a corner of each view; a click on an end looks from there"));
    say(loupe, tr("&Loupe"), tr("Enlarge what is under the pointer"));
    if (m_modelShown)
        for (QAction* action : ofCameraPictures()) action->setToolTip(modelStandsInPlace());
    say(record, tr("&Record"), tr("Record the camera's moves as a path"));
    say(addPose, tr("&Add this pose"), tr("Add the present camera to the path"));
    say(savePath, tr("&Save the path…"), tr("Save the recorded path as a file"));
    say(openPath, tr("&Open a path…"), tr("Open a camera path to play it"));
    say(play, tr("&Play"), tr("Play the path, a picture of every view at every pose"));
    say(stop, tr("S&top"), tr("Stop recording and playing"));
    say(poseOn, tr("One pose o&n"), tr("Show the next pose of the path, without measuring"));
    say(poseBack, tr("One pose bac&k"), tr("Show the pose before, without measuring"));
    builtInPaths->setTitle(tr("&Built-in paths"));
}

}  // namespace cullscope::ui
