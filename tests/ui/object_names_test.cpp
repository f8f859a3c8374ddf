// Objects have their names in the picture where sentences and questions name them, and the quiz is asked about its order.
#include <QTemporaryDir>
#include <fstream>

#include "tests/ui/shown_window.h"

namespace cullscope::ui::object_names_test {
namespace {

struct ObjectNames : Window {
    void openScene(const QString& scene) {
        openAndWait(session, scene);
        settle();
        ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0); }));
    }

    /// The names of the first view's picture, each of which lies in it.
    std::string names() {
        QStringList names;
        for (const PlacedName& name : picture(0).extras().names) {
            names << name.text;
            const Viewport size = session.picture(0)->request.size;
            EXPECT_TRUE(QRectF(0, 0, size.width, size.height).contains(name.place)) << name.text.toStdString();
        }
        return names.join(QLatin1Char(' ')).toStdString();
    }
};

TEST_F(ObjectNames, theQuizHasThemAlwaysAndIsAskedAboutItsOrder) {
    openScene(QStringLiteral("quiz"));
    EXPECT_EQ(names(), "A B C");
    // They are painted: without them the same picture has other pixels.
    PictureExtras extras = picture(0).extras();
    const auto painted = [&] {
        QImage image(640, 480, QImage::Format_RGB32);
        QPainter painter(&image);
        paintPicture(painter, image.rect(), *session.picture(0), extras);
        return image;
    };
    const QImage named = painted();
    extras.names.clear();
    EXPECT_NE(named, painted());
    window.actions().questionFirst->trigger();
    EXPECT_EQ(session.question()->question, Prediction::Question::Order);
    EXPECT_EQ(names(), "A B C");
}

TEST_F(ObjectNames, eachStandsWhereItsOwnPolygonIsSeen) {
    openScene(QStringLiteral("quiz"));
    const Scene& scene = *session.scene();
    const SceneView& view = picture(0);
    for (const PlacedName& name : view.extras().names) {
        const PictureLayout layout = view.pictureLayout();
        const Viewport size = session.picture(0)->request.size;
        const std::optional<Vec3> surface = view.surfaceAt(layout.positionOf({name.place.x(), size.height - name.place.y()}));
        ASSERT_TRUE(surface) << name.text.toStdString() << " stands beside everything";
        // The letters are painted there, and not above it on another polygon.
        const auto painted = [&](const std::vector<PlacedName>& names) {
            PictureExtras extras = view.extras();
            extras.names = names;
            QImage image(size.width, size.height, QImage::Format_RGB32);
            QPainter painter(&image);
            paintPicture(painter, image.rect(), *session.picture(0), extras);
            return image;
        };
        const QImage with = painted({name}), without = painted({});
        QRect letters;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                if (with.pixel(x, y) != without.pixel(x, y)) letters |= QRect(x, y, 1, 1);
        EXPECT_TRUE(letters.contains(name.place.toPoint())) << name.text.toStdString();
        for (size_t i = 0; i < scene.instances().size(); ++i) {
            const Box3 box = scene.instanceBox(i);
            const Vec3 margin(0.05);
            const Vec3 below = glm::max(box.min - margin - *surface, Vec3(0.0)),
                       over = glm::max(*surface - box.max - margin, Vec3(0.0));
            EXPECT_EQ(below + over == Vec3(0.0), scene.instances()[i].name == name.text.toStdString())
                << name.text.toStdString() << " and " << scene.instances()[i].name;
        }
    }
}

TEST_F(ObjectNames, otherScenesHaveThemInAQuestionAlone) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("two.obj"));
    std::ofstream(file.toStdString())
        << "o Left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no Right\nv 2 0 0\nv 3 0 0\nv 2 1 0\nf 4 5 6\n";
    openScene(file);
    EXPECT_EQ(names(), "");
    window.actions().questionFirst->trigger();
    EXPECT_EQ(session.question()->question, Prediction::Question::Vanish) << "no planes give an order";
    EXPECT_EQ(names(), "Left Right");
    // More names than can be read are none.
    openScene(QStringLiteral("quiz"));
    openScene(QStringLiteral("field:mesh=sphere:triangles=80,n=6"));
    window.actions().questionFirst->trigger();
    ASSERT_TRUE(session.question());
    EXPECT_EQ(names(), "");
}

}  // namespace
}  // namespace cullscope::ui::object_names_test
