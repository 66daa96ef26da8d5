#include "sim/world_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/angles.h"
#include "config/text_file.h"
#include "sim/view.h"
#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

// A unit pyramid as other programs write it: a quadrilateral, indices with texture slots, negative
// ones.
constexpr const char* kPyramid =
    "# pyramid\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 3\nvt 0 0\n"
    "f 4/1 3/1 2/1 1/1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf -2 1 -1\n";

std::filesystem::path WriteMesh(const std::string& name, const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / name;
  EXPECT_TRUE(config::WriteFileAtomically(file, text).ok());
  return file;
}

TEST(WorldSceneTest, ReadsAnObjMesh) {
  const Result<geons::TriangleMesh> mesh = LoadObj(WriteMesh("pyramid.obj", kPyramid));
  ASSERT_TRUE(mesh.ok()) << mesh.message();
  EXPECT_EQ(mesh->triangles.size(), 6u);
  EXPECT_NEAR(geons::Volume(*mesh), 2.0 * 2.0 * 3.0 / 3.0, 1e-5);
}

TEST(WorldSceneTest, RefusesWhatIsNoMesh) {
  EXPECT_THAT(LoadObj("nowhere.obj").message(), ::testing::HasSubstr("nowhere.obj"));
  EXPECT_FALSE(LoadObj(WriteMesh("empty.obj", "# nothing\n")).ok());
  EXPECT_FALSE(LoadObj(WriteMesh("broken.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n")).ok());
}

TEST(WorldSceneTest, MeshIsScaledToItsHeightAndPutInItsPlace) {
  const std::filesystem::path file = WriteMesh("scaled.obj", kPyramid);
  const World world = WorldFrom("  - {mesh: \"" + file.string() +
                                "\", height_m: 0.3, x_m: 1.0, y_m: 2.0, yaw_deg: 45}\n");
  const Result<geons::TriangleMesh> mesh = ObjectMesh(world, world.objects[0]);
  ASSERT_TRUE(mesh.ok()) << mesh.message();
  const auto bounds = geons::Bounds(*mesh);
  EXPECT_NEAR(bounds.min().z(), 0.0, 1e-6);
  EXPECT_NEAR(bounds.max().z(), 0.3, 1e-6);
  EXPECT_NEAR(bounds.center().x(), 1.0, 1e-6);
  EXPECT_NEAR(bounds.sizes().x(), 0.2 * std::sqrt(2.0), 1e-5);
}

TEST(WorldSceneTest, BodiesAreTheFloorFourWallsAndTheObjects) {
  const auto scene = SceneFrom(
      "  - {box: [0.5, 0.5, 0.7], x_m: 1.5, y_m: 2.0}\n"
      "  - {geon: cuboid, size_m: [0.1, 0.1, 0.2], x_m: 1.5, y_m: 2.0}\n");
  ASSERT_EQ(scene->bodies().size(), 7u);
  EXPECT_EQ(scene->bodies()[0].name, "floor");
  EXPECT_EQ(scene->bodies()[6].name, "cuboid");
  EXPECT_NEAR(geons::Bounds(scene->bodies()[6].surface_W).min().z(), 0.7, 1e-9);
}

TEST(WorldSceneTest, MissingMeshIsNamed) {
  const World world = WorldFrom("  - {mesh: missing.obj, height_m: 0.3, x_m: 1.0, y_m: 2.0}\n");
  EXPECT_THAT(BuildScene(world).message(), ::testing::HasSubstr("missing.obj"));
}

// The head's camera, 1 m before a geon, looks at it as it is and as if it were made four times as
// fine: by how much of a pixel is the outline off, and what lies within it?
TEST(WorldSceneTest, GeonsAreMadeSoFineThatNobodySeesTheirFacets) {
  const geometry::PinholeCamera camera = {640, 480, 1600.0, 1600.0, 319.5, 239.5};
  for (const char* geon :
       {"{geon: cylinder, size_m: [0.2, 0.2, 0.2], x_m: 1.5, y_m: 1.6}\n",
        "{geon: ellipsoid, size_m: [0.2, 0.24, 0.2], x_m: 1.5, y_m: 1.6}\n",
        "{geon: bent_cylinder, size_m: [0.08, 0.08, 0.3], bend_deg: 120, x_m: 1.5, y_m: 1.6}\n",
        "{geon: tapered_cuboid, size_m: [0.2, 0.14, 0.2], taper: 0.3, x_m: 1.5, y_m: 1.6, "
        "yaw_deg: 20}\n"}) {
    const World world = WorldFrom(std::string("  - ") + geon);
    const auto made = *BuildScene(world), fine = *BuildScene(world, {512, 384});
    const int body = static_cast<int>(made->bodies().size()) - 1;
    const geometry::RigidTransform X_WC =
        geometry::MakeTransform(geometry::RotationAboutX(-kPi / 2 - 0.1), {1.5, 0.5, 0.2});
    View as_made, as_fine;
    LookThrough(*made, camera, X_WC, &as_made);
    LookThrough(*fine, camera, X_WC, &as_fine);
    const auto on_geon = [&](const Scene& scene, int facet) {
      return facet != View::kNothing &&
             scene.facets().facets()[static_cast<size_t>(facet)].body == body;
    };
    int otherwise = 0, outline = 0, within = 0;
    double depth_m = 0.0;
    for (size_t k = 1; k < as_made.facet.size(); ++k) {
      const bool here = on_geon(*made, as_made.facet[k]), truly = on_geon(*fine, as_fine.facet[k]);
      otherwise += here != truly ? 1 : 0;
      outline += truly != on_geon(*fine, as_fine.facet[k - 1]) ? 1 : 0;
      if (!here || !truly) continue;
      ++within;
      depth_m += std::abs(1.0 / as_made.nearness_1_m[k] - 1.0 / as_fine.nearness_1_m[k]);
    }
    ASSERT_GT(outline, 200) << geon;
    RecordProperty("off_px", std::to_string(static_cast<double>(otherwise) / outline));
    EXPECT_LT(static_cast<double>(otherwise) / outline, 0.1) << geon;
    EXPECT_LT(depth_m / within, 1e-4) << geon;  // a fifth of what 0.1 px of a stripe is worth
  }
}

}  // namespace
}  // namespace geon::sim
