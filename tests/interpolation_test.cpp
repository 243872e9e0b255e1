// Flat, Gouraud and Phong interpolation of baked meshes, against Lambert's law worked out in double precision, and against each other.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "bake/bake.h"
#include "bake/framing.h"
#include "bake/sphere_mesh.h"
#include "gbuffer/write_parts.h"
#include "tests/baked_file.h"
#include "tests/run_program.h"

namespace relume {
namespace {

const glm::dvec3 to_light = glm::normalize(glm::dvec3(1, 2, 3));

class Interpolated : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(out("rig.json")) << R"({"relume": 1, "lights": [{"type": "directional", "direction": [-1, -2, -3], "intensity": [2, 1, 0.5]}]})";
    std::ofstream(out("many.json")) << R"({"relume": 1, "lights": [{"type": "directional", "direction": [-1, -2, -3], "intensity": [2, 1, 0.5]},
      {"type": "point", "position": [2, 2, 2], "intensity": [9, 9, 9]}, {"type": "ambient", "fraction": 0.1}]})";
  }

  std::string out(const std::string& name) const { return (folder_ / name).string(); }

  /// A sphere seen by parallel rays; how long its edges are.
  double bake_sphere(int cuts, const std::string& name) const {
    Mesh mesh = sphere_mesh(cuts);
    const double edge = mean_edge(mesh);
    BakeJob job;
    job.output = out(name);
    job.camera.world_from_camera = looking_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
    job.camera.projection = Camera::Projection::orthographic;
    job.camera.height = 2.2;
    job.width = job.height = 96;
    bake(std::move(mesh), job, [](double) {});
    return edge;
  }

  StoredPart shade(const std::string& gbuffer, const std::string& interpolation, std::vector<std::string> options) const {
    std::vector<std::string> all{"shade", out(gbuffer), "-o", out("lit.exr"), "--overwrite", "--interpolation", interpolation, "--device", "twin"};
    all.insert(all.end(), options.begin(), options.end());
    const ProgramRun run = run_program(all);
    EXPECT_EQ(run.code, 0) << run.err;
    return {out("lit.exr"), 0};
  }
  std::vector<std::string> lambert() const {
    return {"-l", out("rig.json"), "--diffuse", "lambert", "--specular", "none", "--set", "albedo=0.5,0.5,0.5"};
  }
  std::vector<std::string> shiny() const {
    return {"-l",    out("many.json"), "--diffuse", "lambert", "--specular", "phong",
            "--set", "exponent=20",    "--set",     "ks=0.4",  "--layers",   "diffuse,specular,ambient,lights"};
  }

  const TemporaryFolder folder_;
};

double radiance_of(const glm::dvec3& normal) { return 2 * 0.5 / std::numbers::pi * std::max(glm::dot(glm::normalize(normal), to_light), 0.0); }

TEST_F(Interpolated, IsLambertsLawPerPixelVertexOrFacet) {
  bake_sphere(3, "sphere.exr");
  const StoredPart pixels(out("sphere.exr"), 0), vertices(out("sphere.exr"), 1), facets(out("sphere.exr"), 2);
  const StoredPart phong = shade("sphere.exr", "phong", lambert()), gouraud = shade("sphere.exr", "gouraud", lambert()),
                   flat = shade("sphere.exr", "flat", lambert());
  int seen = 0;
  for (std::int64_t i = 0; i < pixels.window.pixels(); ++i) {
    const bool hit = pixels.value("A", i) > 0;
    EXPECT_EQ(gouraud.value("A", i), hit);
    if (!hit) {
      EXPECT_EQ(gouraud.value("R", i), 0);
      continue;
    }
    ++seen;
    const auto facet = std::int64_t(pixels.value("triangle", i));
    const double u = pixels.value("barycentric.U", i), v = pixels.value("barycentric.V", i), weights[] = {1 - u - v, u, v};
    double mixed = 0;
    for (int k = 0; k < 3; ++k)
      mixed += weights[k] * radiance_of(vertices.vector("N", std::int64_t(facets.value("vertex" + std::to_string(k), facet))));
    EXPECT_NEAR(phong.value("R", i), radiance_of(pixels.vector("N", i)), 1e-6);
    EXPECT_NEAR(gouraud.value("R", i), mixed, 1e-6);
    EXPECT_NEAR(flat.value("R", i), radiance_of(pixels.vector("Ng", i)), 1e-6);
  }
  EXPECT_GT(seen, 5000);
}

TEST_F(Interpolated, LayersAddUpToTheTotal) {
  bake_sphere(4, "sphere.exr");
  for (const char* kind : {"gouraud", "flat"}) {
    const StoredPart lit = shade("sphere.exr", kind, shiny());
    for (std::int64_t i = 0; i < lit.window.pixels(); ++i)
      for (const char* c : {".R", ".G", ".B"}) {
        const double total = lit.value(c + 1, i), tolerance = 1e-5 * (1 + total);
        EXPECT_NEAR(lit.value(std::string("diffuse") + c, i) + lit.value(std::string("specular") + c, i) + lit.value(std::string("ambient") + c, i),
                    total, tolerance);
        EXPECT_NEAR(lit.value(std::string("light.directional0") + c, i) + lit.value(std::string("light.point1") + c, i) +
                        lit.value(std::string("ambient") + c, i),
                    total, tolerance);
      }
  }
}

/// Root of the mean square over pixels that both show, over the mean of one.
double difference(const StoredPart& a, const StoredPart& b) {
  double squares = 0, sum = 0;
  for (std::int64_t i = 0; i < a.window.pixels(); ++i) {
    squares += std::pow(double(a.value("R", i)) - b.value("R", i), 2);
    sum += b.value("R", i);
  }
  return std::sqrt(squares * double(a.window.pixels())) / sum;
}

TEST_F(Interpolated, AgreeInTheLimitOfAFineMesh) {
  const double coarse_edge = bake_sphere(8, "coarse.exr"), fine_edge = bake_sphere(32, "fine.exr");
  const auto apart = [&](const char* name) { return difference(shade(name, "gouraud", shiny()), shade(name, "phong", shiny())); };
  const double coarse = apart("coarse.exr"), fine = apart("fine.exr"), slope = std::log(coarse / fine) / std::log(coarse_edge / fine_edge);
  EXPECT_GT(coarse, 1e-3);
  EXPECT_NEAR(slope, 2, 0.25);  // linear interpolation misses a smooth function by the square of its step
}

TEST_F(Interpolated, SmallBandsChangeNothing) {
  bake_sphere(5, "sphere.exr");
  shade("sphere.exr", "gouraud", shiny());
  const std::string whole = text_of_file(out("lit.exr"));
  std::vector<std::string> small = shiny();
  small.insert(small.end(), {"--memory", "400K"});
  shade("sphere.exr", "gouraud", small);
  EXPECT_TRUE(text_of_file(out("lit.exr")) == whole);
}

TEST_F(Interpolated, RefusesFilesWithoutTheLists) {
  std::ofstream(out("camera.json")) << R"({"relume": 1, "lights": [], "camera": {"world_from_camera": [1,0,0,0, 0,1,0,0, 0,0,1,9, 0,0,0,1]}})";
  const auto refused = [&](const char* gbuffer, const std::string& said) {
    const ProgramRun run = run_program({"shade", out(gbuffer), "-l", out("rig.json"), "-o", out("no.exr"), "--interpolation", "gouraud", "--device",
                                        "twin", "--camera", out("camera.json")});
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find(said), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(out("no.exr")));
  };
  const std::vector<Channel> surface{{"P.X", SampleType::float32}, {"P.Y", SampleType::float32}, {"P.Z", SampleType::float32},
                                     {"N.X", SampleType::float32}, {"N.Y", SampleType::float32}, {"N.Z", SampleType::float32}};
  std::vector<Channel> pixels = surface, facets = surface;
  pixels.insert(pixels.end(), {{"triangle", SampleType::uint32}, {"barycentric.U", SampleType::float32}, {"barycentric.V", SampleType::float32}});
  for (const char* name : {"vertex0", "vertex1", "vertex2"}) facets.push_back({name, SampleType::uint32});
  const auto write = [&](const char* name, const std::vector<OutputPart>& parts) {
    PartsWriter writer(out(name), "zip", false, {0, 0, 4, 4}, parts);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const std::vector<float> ones(std::size_t(parts[p].window.pixels()), 1);  // as a whole number 1 << 30 and more
      const std::vector<const void*> samples(parts[p].channels.size(), ones.data());
      writer.write_rows(p, parts[p].window.height(), samples);
    }
    writer.commit();
  };
  write("bare.exr", {{"main", {0, 0, 4, 4}, pixels, {}}});
  refused("bare.exr", "no part \"vertices\" (relume bake writes one; --interpolation phong needs none)");
  write("wild.exr", {{"main", {0, 0, 4, 4}, pixels, {}}, {"vertices", {0, 0, 3, 1}, surface, {}}, {"facets", {0, 0, 1, 1}, facets, {}}});
  refused("wild.exr", "a number of a vertex is 1065353216, beyond the list of 3");
}

TEST_F(Interpolated, FigureShowsTheLostHighlight) {
  const std::vector<std::string> command{"figure", "interpolation", "-o", out("figure.svg"), "--csv", out("figure.csv"), "--device", "twin"};
  ASSERT_EQ(run_program(command).code, 0);
  EXPECT_TRUE(text_of_file(out("figure.svg")).starts_with("<?xml"));
  std::istringstream csv(text_of_file(out("figure.csv")));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "column,facet,gouraud,phong,gouraud_second_difference,phong_second_difference");
  struct Row {
    int column;
    long long facet;
    double gouraud, phong, bend;
  };
  std::vector<Row> rows;
  while (std::getline(csv, line))
    if (Row row{}; std::sscanf(line.c_str(), "%d,%lld,%lf,%lf,%lf", &row.column, &row.facet, &row.gouraud, &row.phong, &row.bend) == 5)
      rows.push_back(row);
  double gouraud = 0, phong = 0, within = 0, across = 0;
  for (std::size_t i = rows.size() / 10; i < rows.size() * 9 / 10; ++i) {  // but for where the sphere turns away
    gouraud = std::max(gouraud, rows[i].gouraud), phong = std::max(phong, rows[i].phong);
    double& bend = rows[i - 1].facet == rows[i].facet && rows[i].facet == rows[i + 1].facet ? within : across;
    bend = std::max(bend, std::abs(rows[i].bend));
  }
  EXPECT_GT(phong, 10 * gouraud);           // the highlight falls between vertices
  EXPECT_GT(across, 10 * within);           // Gouraud's radiance bends at facets' edges alone
  EXPECT_EQ(run_program(command).code, 5);  // exists
  EXPECT_EQ(run_program({"figure", "interpolation", "-o", out("figure.txt")}).code, 2);
  EXPECT_EQ(run_program({"figure", "interpolation", "-o", out("other.svg"), "--row", "9999"}).code, 2);
  EXPECT_EQ(run_program({"figure", "interpolation", out("figure.csv"), "-o", out("other.svg")}).code, 2);
  EXPECT_FALSE(std::filesystem::exists(out("other.svg")));
}

}  // namespace
}  // namespace relume
