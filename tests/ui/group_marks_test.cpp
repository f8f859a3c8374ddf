// The tree of a strategy and the views, linked both ways: a chosen node is marked in the view, what is picked there has its row.

#include "tests/ui/shown_window.h"
#include "ui/panels/structure_panel.h"
#include "ui/views/pick_painter.h"

namespace cullscope::ui::group_marks_test {
namespace {

/// The lecture's quiz with the tree of its planes in the first view.
struct GroupMarks : Window {
    void SetUp() override {
        Window::SetUp();
        show("quiz", "bsp", "plane", "given");
    }

    void show(const char* scene, const char* strategy, const char* key = nullptr, const char* value = nullptr) {
        openAndWait(session, QString::fromLatin1(scene));
        session.setActiveView(0);
        ParameterSet parameters(findStrategy(strategy).info.parameters);
        if (key != nullptr) parameters.setFromText(key, value);
        session.slot(0).choose(strategy);
        session.slot(0).setParameters(parameters);
        window.structurePanel().tabs().setCurrentWidget(&tree());
        ASSERT_TRUE(waitUntil([&] {
            return session.buffers() && !session.slot(0).building() && session.metricsSettled() && !session.pictures()->busy() &&
                   tree().model().rowCount() > 0 && tree().model().nested();
        }));
        QApplication::processEvents();
    }

    StructureTree& tree() { return window.structurePanel().tree(); }

    [[nodiscard]] QModelIndex rowNamed(const QString& start, const QModelIndex& parent = {}) {
        StructureModel& model = tree().model();
        for (int row = 0; row < model.rowCount(parent); ++row) {
            const QModelIndex index = model.index(row, 0, parent);
            if (index.data().toString().startsWith(start)) return index;
            if (const QModelIndex below = rowNamed(start, index); below.isValid()) return below;
        }
        return {};
    }
    [[nodiscard]] QString selectedRow() {
        const QModelIndexList rows = tree().view().selectionModel()->selectedRows();
        return rows.isEmpty() ? QString() : rows.front().data().toString();
    }
    [[nodiscard]] QImage shown() { return picture(0).grab().toImage(); }

    /// The part of a view's pixels that another picture of it has in other colours.
    static double changed(const QImage& a, const QImage& b) {
        size_t count = 0;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
        return double(count) / (double(a.width()) * a.height());
    }
};

TEST_F(GroupMarks, chosenNodeIsMarkedInTheViewWithItsPlaneAndItsPolygons) {
    const QImage before = shown();
    const QModelIndex plane = rowNamed(QStringLiteral("P2"));
    ASSERT_TRUE(plane.isValid());
    tree().view().setCurrentIndex(plane);
    ASSERT_TRUE(session.group());
    ASSERT_NE(session.groupOf(0), nullptr);
    EXPECT_EQ(session.group()->shape.polygons.size(), 1u);
    EXPECT_EQ(session.groupOf(1), nullptr) << "the other view has another strategy";
    const QImage ofPlane = shown();
    EXPECT_GT(changed(before, ofPlane), 0.02) << "the plane is filled within its cell";
    const QModelIndex leaf = rowNamed(QStringLiteral("C4"));
    ASSERT_TRUE(leaf.isValid());
    tree().view().setCurrentIndex(leaf);
    EXPECT_TRUE(session.group()->shape.polygons.empty());
    EXPECT_FALSE(session.group()->shape.triangles.empty());
    EXPECT_GT(changed(before, shown()), 0.002);
    EXPECT_GT(changed(ofPlane, shown()), 0.02) << "one node is marked at a time";
    tree().view().clearSelection();
    EXPECT_FALSE(session.group());
    EXPECT_EQ(changed(before, shown()), 0.0);
}

TEST_F(GroupMarks, pickedTriangleSelectsTheNodeThatKeepsIt) {
    tree().view().setCurrentIndex(rowNamed(QStringLiteral("P1")));
    const uint64_t a = session.scene()->firstTriangle(0);
    session.setPick(Pick{0, a, Vec3(-1, 0.9, 1.2)});
    EXPECT_FALSE(session.group()) << "what is picked takes the place of what was chosen";
    ASSERT_TRUE(waitUntil([&] { return selectedRow().startsWith(QStringLiteral("C4")); })) << selectedRow().toStdString();
    session.setPick(Pick{0, a, Vec3(-1, 0.9, -1.2)});
    ASSERT_TRUE(waitUntil([&] { return selectedRow().startsWith(QStringLiteral("C2")); })) << selectedRow().toStdString();
    EXPECT_FALSE(session.group()) << "a row that follows the pick is not chosen by hand";
    session.setPick(std::nullopt);
    EXPECT_TRUE(waitUntil([&] { return selectedRow().isEmpty(); }));
}

TEST_F(GroupMarks, groupsOfAnOctreeAreMarkedByTheirBox) {
    show("field:mesh=sphere:triangles=80,n=4", "frustum-octree");
    const QImage before = shown();
    const QModelIndex root = tree().model().index(0, 0);
    ASSERT_TRUE(tree().model().groupAt(root));
    tree().view().setCurrentIndex(root);
    ASSERT_TRUE(session.group());
    EXPECT_EQ(session.group()->shape.boxes.size(), 1u);
    EXPECT_GT(changed(before, shown()), 0.0005);
    // An object's row picks the object, as before.
    const QModelIndex object = tree().model().indexOfInstance(5);
    tree().view().setCurrentIndex(object);
    EXPECT_FALSE(session.group());
    ASSERT_TRUE(session.pick());
    EXPECT_EQ(session.pick()->object, 5u);
}

TEST_F(GroupMarks, groupEndsWithWhatWasBuilt) {
    tree().view().setCurrentIndex(rowNamed(QStringLiteral("P1")));
    ASSERT_TRUE(session.group());
    session.slot(0).choose("frustum");
    ASSERT_TRUE(waitUntil([&] { return !session.slot(0).building() && !session.group(); }));
    show("quiz", "bsp", "plane", "given");
    tree().view().setCurrentIndex(rowNamed(QStringLiteral("P1")));
    ASSERT_TRUE(session.group());
    openAndWait(session, QStringLiteral("torus:triangles=200"));
    EXPECT_FALSE(session.group());
    settle();
}

TEST_F(GroupMarks, steppedNodeHasItsPlane) {
    window.actions().stepThrough->trigger();
    ASSERT_TRUE(waitUntil([&] { return window.stepper().place() && session.step(); }));
    window.stepper().jump(2);
    ASSERT_TRUE(session.step()->shape.node);
    EXPECT_EQ(session.step()->shape.polygons.size(), 1u);
    EXPECT_EQ(session.groupOf(0), nullptr);
}

TEST_F(GroupMarks, steppedPartIsLitWithThePlaneOfItsNodeAndCalledAsInTheTree) {
    show("quiz", "bsp", "plane", "balance");
    window.actions().stepThrough->trigger();
    ASSERT_TRUE(waitUntil([&] { return window.stepper().place() && session.step(); }));
    bool drawn = false;
    for (size_t step = 1; step <= window.stepper().place()->count(); ++step) {
        window.stepper().jump(step);
        const std::optional<FrameEntry> entry = window.stepper().place()->current();
        if (entry->decision == nullptr || entry->decision->subject.kind == Subject::Kind::Object) continue;
        const SubjectShape& shape = session.step()->shape;
        ASSERT_TRUE(shape.node);
        EXPECT_EQ(shape.polygons.size(), 1u) << "the plane";
        EXPECT_FALSE(shape.triangles.empty()) << "the polygons in it";
        const bool isPart = entry->decision->subject.kind == Subject::Kind::Fragment;
        EXPECT_EQ(shape.boxes.empty(), isPart);
        drawn = drawn || isPart;
    }
    EXPECT_TRUE(drawn);
}

TEST_F(GroupMarks, comparedPolygonsAreMarkedInTheViewAndInItsObserver) {
    openAndWait(session, QStringLiteral("quiz"));
    session.slot(0).choose("painter");
    ASSERT_TRUE(waitUntil([&] {
        return session.buffers() && !session.slot(0).building() && session.metricsSettled() && !session.pictures()->busy();
    }));
    session.observe(1, 0);
    window.actions().stepThrough->trigger();
    ASSERT_TRUE(waitUntil([&] { return window.stepper().place() && session.step(); }));
    window.stepper().jump(1);
    EXPECT_TRUE(window.stepper().sentence().startsWith(QStringLiteral("6 polygons are sorted"))) << "about no node";
    const auto jumpTo = [&](bool compares) {
        for (size_t step = window.stepper().place()->step() + 1; step < window.stepper().place()->count(); ++step) {
            window.stepper().jump(step);
            if (session.step()->shape.compared.empty() != compares) break;
        }
        ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0) && session.pictures()->isCurrent(1); }));
        QApplication::processEvents();
    };
    ASSERT_NO_FATAL_FAILURE(jumpTo(true));
    ASSERT_EQ(session.step()->shape.compared.size(), 1u);
    ASSERT_EQ(session.step()->shape.lines.size(), 1u);
    EXPECT_TRUE(session.step()->shape.boxes.empty());
    // The same picture of the scene without Q.
    const SubjectShape shape = session.step()->shape;
    SubjectShape alone = shape;
    alone.compared.clear();
    for (const int view : {0, 1}) {
        const ViewPicturePointer shown = session.picture(view);
        const View viewing(shown->request.viewing, shown->request.size);
        const auto painted = [&](const SubjectShape& marked) {
            QImage image(int(viewing.viewport().width), int(viewing.viewport().height), QImage::Format_ARGB32);
            image.fill(Qt::gray);
            QPainter painter(&image);
            paintSubject(painter, marked, viewing, PictureLayout(image.size(), 1.0, viewing.viewport()), view == 0);
            return image;
        };
        QImage none(painted({}));
        EXPECT_GT(changed(painted(alone), none), 0.0005) << "P in view " << view;
        EXPECT_GT(changed(painted(shape), painted(alone)), 0.0005) << "Q in view " << view;
    }
}

}  // namespace
}  // namespace cullscope::ui::group_marks_test
