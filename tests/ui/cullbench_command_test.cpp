#include "ui/session/cullbench_command.h"

#include <gtest/gtest.h>

#include <QDir>
#include <cmath>

#include "core/visibility/registry.h"

namespace cullscope::ui::cullbench_command_test {
namespace {

TEST(CullbenchCommand, repeatsTheView) {
    PictureSubject picture;
    picture.scene = "/my models/it's.obj";
    picture.strategy = "frustum";
    picture.parameters = ParameterSet(findStrategy("frustum").info.parameters);
    picture.parameters.setFromText("box", "length");
    picture.culling.eye = picture.viewing.eye = Vec3(-1.5, 0.1, 3.0);
    picture.size = picture.cullingSize = {640, 480};
    picture.style = {Vec3f(1.0f), 1.0f, Vec3f(8.0f, 16.0f, 255.0f) / 255.0f};
    EXPECT_EQ(cullbenchCommand(picture).toStdString(),
              "cullbench render '/my models/it'\\''s.obj' -s frustum -p box=length --eye=-1.5,0.1,3 --target=0,0,0 --up=0,1,0 "
              "--fovy=45 --near=0.05 --far=1000 --size=640x480 --background=ffffff --surface=0810ff -o view.png");
}

TEST(CullbenchCommand, relativeFilesAreNamedWithTheirFolder) {
    const QString here = QDir::currentPath();
    const auto sceneOf = [](const char* scene) {
        PictureSubject picture;
        picture.scene = scene;
        picture.strategy = "all";
        return cullbenchArguments(picture, QStringLiteral("x.png")).at(1);
    };
    EXPECT_EQ(sceneOf("castle.obj"), here + QStringLiteral("/castle.obj"));
    EXPECT_EQ(sceneOf("mesh:a,b.obj,triangles=10"), QStringLiteral("mesh:") + here + QStringLiteral("/a,b.obj,triangles=10"));
    EXPECT_EQ(sceneOf("mesh:bunny,triangles=10"), QStringLiteral("mesh:bunny,triangles=10"));
    EXPECT_EQ(sceneOf("field:n=3,mesh=sub/x.ply"), QStringLiteral("field:n=3,mesh=") + here + QStringLiteral("/sub/x.ply"));
    EXPECT_EQ(sceneOf("field:mesh=bunny,n=3"), QStringLiteral("field:mesh=bunny,n=3"));
    EXPECT_EQ(sceneOf("sphere:triangles=80"), QStringLiteral("sphere:triangles=80"));
    EXPECT_EQ(sceneOf("bunny"), QStringLiteral("bunny"));
    PictureSubject picture;
    picture.modelFolders = {"models"};
    EXPECT_EQ(cullbenchArguments(picture, {}).mid(0, 2),
              (QStringList{QStringLiteral("--models"), here + QStringLiteral("/models")}));
}

TEST(CullbenchCommand, theFieldOfViewIsNotRoundedOnTheWay) {
    for (int i = 0; i < 200; ++i) {
        PictureSubject picture;
        picture.culling.fovy = picture.viewing.fovy = Angle::fromDegrees(45.0 * std::pow(1.06, double(i % 20) - 10.0) + 0.01 * i);
        const QStringList words = cullbenchArguments(picture, {});
        const QString word = words.filter(QStringLiteral("--fovy=")).value(0);
        EXPECT_EQ(Angle::fromDegrees(word.section(QLatin1Char('='), 1).toDouble()), picture.culling.fovy) << word.toStdString();
    }
}

}  // namespace
}  // namespace cullscope::ui::cullbench_command_test
