// relume bake: against Cycles' and Mitsuba's buffers of the same meshes, against a plane worked out by hand, and whatever is no mesh.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <fstream>

#include "bake/bake.h"
#include "bake/framing.h"
#include "bake/read_mesh.h"
#include "gbuffer/picture.h"
#include "gbuffer/reading.h"
#include "tests/baked_file.h"
#include "tests/run_program.h"

namespace relume {
namespace {

namespace fs = std::filesystem;
const fs::path corpus = RELUME_CORPUS;

struct Agreement {
  std::int64_t pixels = 0, mixed = 0, uncovered = 0;
  double position = 0, normal = 0;  ///< largest distance over the mesh's size; largest angle in degrees
};

/// `wanted`: which of the reference's pixels show the mesh; `normal`: its layer of normals.
template <class Wanted>
Agreement agreement(const StoredPart& baked, const StoredPart& reference, const std::string& position, const std::string& normal,
                    const Wanted& wanted) {
  Agreement a;
  glm::dvec3 lowest(1e9), highest(-1e9);
  for (std::int64_t i = 0; i < baked.window.pixels(); ++i) {
    const bool hit = baked.value("A", i) > 0;
    if (hit != wanted(i)) ++a.uncovered;
    if (!hit || !wanted(i)) continue;
    ++a.pixels;
    lowest = glm::min(lowest, baked.vector("P", i)), highest = glm::max(highest, baked.vector("P", i));
    a.position = std::max(a.position, glm::distance(baked.vector("P", i), reference.vector(position, i)));
    // A mean over triangles, which the reference holds where its samples met an edge, is short of unit length.
    constexpr double rounding = 3e-6;
    const glm::dvec3 n = reference.vector(normal, i);
    if (std::abs(glm::length(n) - 1) > rounding)
      ++a.mixed;
    else
      a.normal = std::max(a.normal, degrees_between(baked.vector("N", i), n));
  }
  a.position /= glm::distance(lowest, highest);
  return a;
}

class BakedMesh : public testing::Test {
 protected:
  ProgramRun run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "bake");
    return run_program(arguments);
  }
  std::string put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  std::string out(const std::string& name = "out.exr") const { return (folder_ / name).string(); }

  const TemporaryFolder folder_;
};

TEST_F(BakedMesh, IsWhatCyclesSaw) {
  const fs::path meshes = corpus / "blender/meshes";
  if (!fs::exists(meshes)) GTEST_SKIP() << "no corpus at " << corpus;
  const StoredPart reference(meshes / "phong.exr", 0);
  for (const std::string name : {"suzanne.glb", "suzanne.obj", "sphere.glb", "sphere.obj"}) {
    const ProgramRun baked = run(
        {(meshes / name).string(), "--camera", (meshes / "rig.gltf").string(), "--world-up", "z", "--size", "320x180", "-o", out(), "--overwrite"});
    ASSERT_EQ(baked.code, 0) << baked.err;
    const bool left = name.starts_with("suzanne");  // it stands in the left half of the picture, the sphere in the right
    const auto shown = [&](std::int64_t i) { return (i % 320 < 160) == left && glm::length(reference.vector("ViewLayer.Normal", i)) > 0.5; };
    const Agreement a = agreement(StoredPart(out(), 0), reference, "ViewLayer.Position", "ViewLayer.Normal", shown);
    EXPECT_EQ(a.uncovered, 0) << name;
    EXPECT_GT(a.pixels, 9000) << name;
    EXPECT_LT(double(a.mixed), 0.05 * double(a.pixels)) << name;
    EXPECT_LT(a.position, 1e-4) << name;
    EXPECT_LT(a.normal, 0.05) << name;
  }
}

TEST_F(BakedMesh, IsWhatMitsubaSaw) {
  const fs::path scene = corpus / "mitsuba/mesh_smooth";
  if (!fs::exists(scene)) GTEST_SKIP() << "no corpus at " << corpus;
  const ProgramRun baked = run({(scene / "mesh.ply").string(), "--camera", (scene / "rig.json").string(), "--size", "144x81", "-o", out()});
  ASSERT_EQ(baked.code, 0) << baked.err;
  const StoredPart reference(scene / "gbuffer.exr", 0), own(out(), 0);
  const auto shown = [&](std::int64_t i) { return glm::length(reference.vector("sh_normal", i)) > 0.5; };
  const Agreement a = agreement(own, reference, "position", "sh_normal", shown);
  EXPECT_EQ(a.uncovered, 0);
  EXPECT_EQ(a.mixed, 0);
  EXPECT_LT(a.position, 1e-6);
  EXPECT_LT(a.normal, 1e-4);
  for (std::int64_t i = 0; i < own.window.pixels(); ++i) {
    if (!shown(i)) continue;
    EXPECT_EQ(own.value("triangle", i), reference.value("prim_index.I", i));
    EXPECT_LT(degrees_between(own.vector("Ng", i), reference.vector("geo_normal", i)), 1e-3);
    EXPECT_NEAR(own.value("uv.U", i), reference.value("uv.U", i), 1e-5);
  }
}

/// Two triangles that fill the picture; its diagonal goes through pixel centres, which belong to one of them.
const char* const square = "v -9 -9 -4\nv 9 -9 -4\nv 9 9 -4\nv -9 9 -4\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";

TEST_F(BakedMesh, APlaneIsWhereItsPixelsSeeIt) {
  put("square.obj", square);
  for (const bool orthographic : {false, true}) {
    std::vector<std::string> options{out("square.obj"), "--eye", "0,0,0", "--target", "0,0,-1", "--size", "64x64", "-o", out(), "--overwrite"};
    for (const char* more : {orthographic ? "--orthographic" : "--fov", orthographic ? "8" : "90"}) options.emplace_back(more);
    ASSERT_EQ(run(options).code, 0);
    const StoredPart baked(out(), 0);
    for (std::int64_t i = 0; i < 64 * 64; ++i) {
      const glm::dvec3 wanted{(double(i % 64) + 0.5 - 32) / 8, (32 - double(i / 64) - 0.5) / 8, -4};
      ASSERT_EQ(baked.value("A", i), 1) << i;  // no hole along the diagonal
      ASSERT_LT(glm::distance(baked.vector("P", i), wanted), 1e-6) << i;
      ASSERT_EQ(baked.value("Z", i), 4) << i;
      ASSERT_EQ(baked.vector("N", i), glm::dvec3(0, 0, 1)) << i;
      ASSERT_NEAR(baked.value("uv.U", i), (wanted.x + 9) / 18, 1e-7) << i;
      ASSERT_EQ(baked.value("id", i), 1);
    }
  }
}

TEST_F(BakedMesh, FromBehindShowsItsOtherSide) {
  put("square.obj", square);
  ASSERT_EQ(run({out("square.obj"), "--eye", "0,0,-9", "--target", "0,0,-4", "--size", "8x8", "-o", out()}).code, 0);
  const StoredPart pixels(out(), 0), vertices(out(), 1), facets(out(), 2);
  EXPECT_EQ(pixels.vector("N", 9), glm::dvec3(0, 0, -1));
  EXPECT_EQ(pixels.vector("Ng", 9), glm::dvec3(0, 0, -1));
  EXPECT_EQ(vertices.vector("N", 0), glm::dvec3(0, 0, -1));
  EXPECT_EQ(facets.vector("N", 1), glm::dvec3(0, 0, -1));
}

TEST_F(BakedMesh, TellsMaterialsAndTextures) {
  Picture texels{2, 1, 3, {1, 0, 0, 0, 0, 1}};
  write_png(out("texels.png"), texels, 0, false);
  put("square.mtl", "newmtl painted\nKd 0.5 0.5 0.5\nmap_Kd texels.png\nPr 0.25\nPm 1\n");
  put("square.obj", "mtllib square.mtl\n" + std::string(square).insert(std::string(square).find("f "), "usemtl painted\n"));
  ASSERT_EQ(run({out("square.obj"), "--eye", "0,0,0", "--target", "0,0,-1", "--orthographic", "17.8", "--size", "90x90", "-o", out()}).code, 0);
  const StoredPart baked(out(), 0);
  const std::int64_t left = 45 * 90 + 10, right = 45 * 90 + 79;  // a quarter of the texture from its edges lie the texels' centres
  EXPECT_NEAR(baked.value("albedo.R", 45 * 90 + 22), 0.5, 0.01);
  EXPECT_GT(baked.value("albedo.R", left), 10 * baked.value("albedo.G", left));
  EXPECT_GT(baked.value("albedo.B", right), 10 * baked.value("albedo.G", right));
  EXPECT_EQ(baked.value("roughness", left), 0.25f);
  EXPECT_EQ(baked.value("metallic", left), 1);
  fs::remove(out("texels.png"));
  const ProgramRun without = run({out("square.obj"), "-o", out("without.exr")});
  EXPECT_EQ(without.code, 0);
  EXPECT_NE(without.err.find("warning: texture \"texels.png\" is left out: "), std::string::npos) << without.err;
}

/// A cube of six quads without normals, some thousand units from the origin.
const char* const cube =
    "v 999 -1 -1\nv 1001 -1 -1\nv 1001 1 -1\nv 999 1 -1\nv 999 -1 1\nv 1001 -1 1\nv 1001 1 1\nv 999 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

TEST_F(BakedMesh, MakesNormalsThatDoNotDependOnHowFacesAreCut) {
  put("cube.obj", cube);
  const Mesh smooth = read_mesh(out("cube.obj"), {});
  ASSERT_EQ(smooth.vertices.size(), 8U);
  for (const MeshVertex& v : smooth.vertices) EXPECT_LT(glm::distance(v.normal, glm::normalize(v.position - glm::dvec3(1000, 0, 0))), 1e-12);
  MeshOptions flat;
  flat.normals = MeshOptions::Normals::flat;
  const Mesh facets = read_mesh(out("cube.obj"), flat);
  for (const MeshTriangle& t : facets.triangles)
    for (const std::uint32_t v : t.vertices) EXPECT_GT(glm::dot(facets.vertices[v].normal, glm::normalize(area_normal(facets, t))), 1 - 1e-12);
}

TEST_F(BakedMesh, BitsDoNotDependOnThreads) {
  put("cube.obj", cube);
  std::string first;
  for (const std::size_t threads : {1, 3, 8}) {
    const tbb::global_control some(tbb::global_control::max_allowed_parallelism, threads);
    Mesh mesh = read_mesh(out("cube.obj"), {});
    BakeJob job;
    job.output = out();
    job.camera = framing(mesh, {0, 1, 0}, 40, 1);
    job.width = job.height = 300;
    job.format.overwrite = true;
    bake(std::move(mesh), job, [](double) {});
    const std::string bytes = text_of_file(out());
    if (first.empty()) first = bytes;
    EXPECT_TRUE(bytes == first) << threads << " threads";
  }
}

TEST_F(BakedMesh, IsReadWithoutAFlag) {
  put("cube.obj", cube);
  for (const char* kind : {"--float", "--half"}) {
    std::vector<std::string> options{out("cube.obj"), "--size", "200x150", "-o", out(), "--overwrite"};
    if (kind == std::string("--half")) options.emplace_back(kind);
    ASSERT_EQ(run(options).code, 0);
    const Reading reading = understand(ExrFile(out()), {});
    EXPECT_EQ(reading.convention, "relume_bake");
    ASSERT_TRUE(reading.camera);
    EXPECT_NE(reading.camera->source.find("of the header"), std::string::npos) << reading.camera->source;
    EXPECT_LT(reading.camera->residual, 0.01) << kind;  // pixels, a thousand units from the origin in single precision
    for (const char* role : {"position", "normal", "base_normal", "depth", "coverage", "ids", "primitive_ids"})
      EXPECT_TRUE(reading.roles.contains(role)) << role;
    for (const std::string& note : reading.notes) EXPECT_EQ(note.find("warning"), std::string::npos) << note;
  }
}

TEST_F(BakedMesh, VerticesAndFacetsAreThePixelsOwn) {
  put("cube.obj", cube);
  ASSERT_EQ(run({out("cube.obj"), "--size", "64x48", "-o", out()}).code, 0);
  const StoredPart pixels(out(), 0), vertices(out(), 1), facets(out(), 2);
  int seen = 0;
  for (std::int64_t i = 0; i < pixels.window.pixels(); ++i) {
    if (pixels.value("A", i) == 0) continue;
    const auto facet = std::int64_t(pixels.value("triangle", i));
    const double u = pixels.value("barycentric.U", i), v = pixels.value("barycentric.V", i);
    glm::dvec3 position(0), normal(0);
    for (int k = 0; k < 3; ++k) {
      const auto vertex = std::int64_t(facets.value("vertex" + std::to_string(k), facet));
      const double weight = k == 0 ? 1 - u - v : k == 1 ? u : v;
      position += weight * vertices.vector("P", vertex);
      normal += weight * vertices.vector("N", vertex);
    }
    EXPECT_LT(glm::distance(position, pixels.vector("P", i)), 2e-4);  // single precision a thousand units from the origin
    EXPECT_LT(degrees_between(normal, pixels.vector("N", i)), 1e-3);
    EXPECT_LT(degrees_between(facets.vector("N", facet), pixels.vector("Ng", i)), 1e-3);
    ++seen;
  }
  EXPECT_GT(seen, 500);
}

TEST_F(BakedMesh, RefusesWhatIsNoMeshInOneLine) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  put("good.obj", triangle);
  struct Refusal {
    std::string file;
    const char* text;
    std::vector<std::string> options;
    const char* said;
  };
  const std::vector<Refusal> all{{"none.obj", nullptr, {}, "none.obj: no such file"},
                                 {"text.txt", "hello", {}, "text.txt: not a mesh by its name (ends in .obj, .ply, .stl, .gltf or .glb)"},
                                 {"empty.ply", "", {}, "empty.ply: not a mesh that can be read: "},
                                 {"json.gltf", "{}", {}, "json.gltf: not a mesh that can be read: "},
                                 {"nan.obj", "v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n", {}, "is not a place (coordinates are numbers up to 1e18)"},
                                 {"far.obj", "v 0 0 0\nv 1e30 0 0\nv 0 1 0\nf 1 2 3\n", {}, "is not a place (coordinates are numbers up to 1e18)"},
                                 {"line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", {}, "line.obj: has no triangles"},
                                 {"index.ply",
                                  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                                  "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2 77\n",
                                  {},
                                  "a face names vertex 77 (there are 3)"},
                                 {"faceless.ply",
                                  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                                  "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0\n",
                                  {},
                                  "faceless.ply: has no triangles"},
                                 {"good.obj", triangle.c_str(), {"--size", "0x5"}, "--size 0x5: is not WxH"},
                                 {"good.obj", triangle.c_str(), {"--size", "999999x999999"}, "--size 999999x999999: is "},
                                 {"good.obj", triangle.c_str(), {"--eye", "1,1"}, "--eye 1,1: is not X,Y,Z"},
                                 {"good.obj", triangle.c_str(), {"--eye", "1,1,1", "--target", "1,1,1"}, "--eye and --target: are one place"},
                                 {"good.obj", triangle.c_str(), {"--fov", "30", "--orthographic", "2"}, "--fov and --orthographic: "},
                                 {"good.obj", triangle.c_str(), {"--camera", "none.json"}, "none.json: no such file"}};
  for (const Refusal& refusal : all) {
    if (refusal.text) put(refusal.file, refusal.text);
    std::vector<std::string> arguments{out(refusal.file), "-o", out()};
    arguments.insert(arguments.end(), refusal.options.begin(), refusal.options.end());
    const ProgramRun refused = run(arguments);
    EXPECT_EQ(refused.code, 2) << refusal.said << "\n" << refused.err;
    EXPECT_NE(refused.err.find(refusal.said), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_FALSE(fs::exists(out()));
  }
}

TEST_F(BakedMesh, SaysWhatItAssumedAndKeepsWhatIsThere) {
  put("cube.obj", cube);
  const ProgramRun framed = run({out("cube.obj"), "--size", "32x32", "-o", out()});
  EXPECT_NE(framed.err.find("note: no camera was given: "), std::string::npos) << framed.err;
  EXPECT_NE(framed.err.find("note: the file has no normals: "), std::string::npos) << framed.err;
  const std::string before = text_of_file(out());
  EXPECT_EQ(run({out("cube.obj"), "-o", out()}).code, 5);
  EXPECT_TRUE(text_of_file(out()) == before);
  const ProgramRun away = run({out("cube.obj"), "--eye", "0,0,9", "--target", "0,0,99", "--size", "8x8", "-o", out("away.exr")});
  EXPECT_EQ(away.code, 0);
  EXPECT_NE(away.err.find("warning: the camera sees nothing of the mesh"), std::string::npos) << away.err;
}

}  // namespace
}  // namespace relume
