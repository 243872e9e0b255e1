// relume bench: what it counts, what it refuses to time, and what it writes. No test asserts a time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

#include "bench/ground_frame.h"
#include "bench/image_check.h"
#include "bench/many_lights_scene.h"
#include "bench/resident_subject.h"
#include "bench/tile_statistics.h"
#include "gbuffer/error.h"
#include "host/twin.h"
#include "run_program.h"

namespace relume {
namespace {

using namespace bench;
using nlohmann::json;

ResidentFrame ground(const std::string& brdf, LightType type = LightType::point, int lights = 3) {
  ResidentFrame frame(ground_source(32, 16), material_named(brdf));
  frame.set_lights(ground_lights(type, lights));
  return frame;
}

/// position - p (3 -); its square (3 *, 2 +), its root, 1/root, l (3 *), n.l (3 *, 2 +); the share (1 *) and irradiance (3 *); albedo times n.l/pi (4
/// *), times irradiance, added to the sum (3 *, 3 +). Sums of products are fused.
TEST(Operations, OfLambertAreThoseCountedByHand) {
  const Operations light = cost_of(ground("lambert+none")).light;
  EXPECT_EQ(light.root, 1);
  EXPECT_EQ(light.divide, 1);
  EXPECT_EQ(light.add, 3 + 2 + 2 + 3);
  EXPECT_EQ(light.multiply, 3 + 3 + 3 + 1 + 3 + 4 + 3);
  EXPECT_EQ(light.fused, 2 + 2 + 3);
  EXPECT_EQ(light.flops(), 32);
  EXPECT_EQ(light.loads, 0);
}

TEST(Operations, OfDirectionalLightNeedNoDistance) {
  const Operations light = cost_of(ground("lambert+none", LightType::directional)).light;
  EXPECT_EQ(light.root + light.divide, 0);
  EXPECT_GT(light.flops(), 0);
}

TEST(Operations, OfPixelsAreTheirPlanes) {
  const Operations pixel = cost_of(ground("lambert+none")).pixel;
  EXPECT_EQ(pixel.stores, 3);
  // position, normal, albedo, program; not the output, of which nothing is another program's
  EXPECT_EQ(pixel.loads, 3 + 3 + 3 + 1);
}

TEST(Operations, GrowWithTheLobe) {
  const double lambert = cost_of(ground("lambert+none")).light.flops(), ggx = cost_of(ground("lambert+ggx")).light.flops(),
               cook_torrance = cost_of(ground("lambert+cook_torrance")).light.flops();
  EXPECT_LT(lambert, ggx);
  EXPECT_LT(ggx, cook_torrance);
}

/// A twin whose first pixel is slightly off.
class WrongDevice : public Device {
 public:
  explicit WrongDevice(std::unique_ptr<Device> twin) : twin_(std::move(twin)) {}
  const DeviceInfo& info() const override { return twin_->info(); }
  std::unique_ptr<Band> bind(const BandData& data) override { return std::make_unique<WrongBand>(twin_->bind(data), data.out); }

 private:
  class WrongBand : public Band {
   public:
    WrongBand(std::unique_ptr<Band> band, Planes* out) : band_(std::move(band)), out_(out) {}
    void shade(const Choice& choice, const Frame& frame, const Progress& progress) override { band_->shade(choice, frame, progress); }
    void run(Entry entry, const Choice& choice, const Frame& frame) override { band_->run(entry, choice, frame); }
    void add_environment(Entry entry, const Choice& choice, const Frame& frame, const Progress& progress) override {
      band_->add_environment(entry, choice, frame, progress);
    }
    void finish() override { out_->plane(1)[0] *= 1.0001f; }

   private:
    std::unique_ptr<Band> band_;
    Planes* out_;
  };
  std::unique_ptr<Device> twin_;
};

TEST(ImageCheck, RefusesAWrongImage) {
  const ResidentFrame frame = ground("lambert+ggx");
  EXPECT_EQ(check_image(*open_twin(1), frame, frame.frame().pixels), "equal");
  WrongDevice wrong(open_twin());
  try {
    check_image(wrong, frame, frame.frame().pixels);
    FAIL() << "a wrong image passed";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind, ErrorKind::device);
    EXPECT_NE(std::string(error.what()).find("not timed, its image is wrong: pixel 0"), std::string::npos) << error.what();
  }
}

TEST(GroundFrame, FacesEveryLightAndTheViewer) {
  const GBuffer frame = ground_source(64, 64).make({}, 0);
  const glm::dvec3 eye = ground_source(1, 1).camera.eye();
  for (const LightType type : {LightType::point, LightType::spot, LightType::directional})
    for (const Light& light : ground_lights(type, 50))
      for (std::size_t i = 0; i < std::size_t(frame.surface_pixels); ++i) {
        glm::dvec3 p, n;
        for (int c = 0; c < 3; ++c) p[c] = frame.planes.plane(frame.position.first + c)[i], n[c] = frame.planes.plane(frame.normal.first + c)[i];
        const glm::dvec3 l = type == LightType::directional ? -light.direction : light.position - p;
        ASSERT_GT(glm::dot(n, l), 0) << i;
        ASSERT_GT(glm::dot(n, eye - p), 0) << i;
        const double cone = type == LightType::spot ? std::cos(light.outer_angle * std::numbers::pi / 180) : -1;
        ASSERT_GE(glm::dot(-glm::normalize(l), light.direction), cone - 1e-9);
      }
}

TEST(ManyLights, AreCulledAndInRangeAsTheyLie) {
  const ManyLights scene = many_lights(64, 36, 1, 7);
  ASSERT_EQ(scene.lights.size(), 1024u);
  const GBuffer frame = scene.source.make({"kd", "ks", "exponent"}, 0);
  const TileStatistics all = tile_statistics(frame, scene.lights);
  EXPECT_EQ(all.brute, double(frame.surface_pixels) * 1024);
  EXPECT_GT(all.culled, all.in_range);
  EXPECT_GT(all.in_range, 0);
  std::vector<Light> far = scene.lights;
  for (Light& light : far) light.position.y += 1e4;
  EXPECT_EQ(tile_statistics(frame, far).culled, 0);
}

const std::vector<std::string> tiny{"bench", "--device", "twin", "--size", "32x16", "--repetitions", "2", "--min-time", "0.0001"};

ProgramRun run_tiny(std::vector<std::string> more) {
  more.insert(more.begin(), tiny.begin(), tiny.end());
  return run_program(more);
}

const std::vector<std::string> one_kernel{"--filter", "kernel/.*/point/", "--brdf", "ggx", "--lights", "2,4", "--lanes", "4"};

ProgramRun run_kernel(const std::vector<std::string>& more) {
  std::vector<std::string> all = one_kernel;
  all.insert(all.end(), more.begin(), more.end());
  return run_tiny(all);
}

TEST(BenchCommand, ListsWhatItWouldMeasure) {
  const ProgramRun run = run_kernel({"--list"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "kernel/none+ggx/point/2/32x16/twin/4\nkernel/none+ggx/point/4/32x16/twin/4\n");
}

TEST(BenchCommand, WritesGoogleBenchmarksLayout) {
  const TemporaryFolder folder;
  const ProgramRun run = run_kernel({"--json", folder / "b.json", "--csv", folder / "b.csv"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("kernel/none+ggx/point/2/32x16/twin/4"), std::string::npos);
  const json all = json::parse(text_of_file(folder / "b.json"));
  EXPECT_TRUE(all["context"].contains("num_cpus"));
  EXPECT_TRUE(all["context"].contains("device_twin"));
  int iterations = 0, aggregates = 0;
  for (const json& b : all["benchmarks"]) {
    for (const char* key : {"name", "run_name", "run_type", "iterations", "real_time", "cpu_time", "time_unit"}) EXPECT_TRUE(b.contains(key)) << b;
    if (b["run_name"] != "kernel/none+ggx/point/2/32x16/twin/4") continue;
    (b["run_type"] == "iteration" ? iterations : aggregates)++;
    EXPECT_NEAR(b["items_per_second"].get<double>() * b["real_time"].get<double>() * 1e-9, 32 * 16 * 2, 1e-3);  // pixels times lights
    EXPECT_EQ(b["label"], "image against the twin: equal");
  }
  EXPECT_EQ(iterations, 2);
  EXPECT_EQ(aggregates, 2);
  const std::string csv = text_of_file(folder / "b.csv");
  EXPECT_EQ(csv.find("name,min_seconds,median_seconds,"), 0u);
  EXPECT_NE(csv.find("\nkernel/none+ggx/point/4/32x16/twin/4,"), std::string::npos);
}

TEST(BenchCommand, MeasuresYardsticksOnTheTwin) {
  const ProgramRun run = run_tiny({"--filter", "yardstick/(ggx|lambert)"});
  ASSERT_EQ(run.code, 0) << run.err;
  for (const char* name : {"yardstick/ggx/relume/twin ", "yardstick/ggx/cpp ", "yardstick/lambert/cpp_1_thread ", "over plain C++, all threads: "})
    EXPECT_NE(run.out.find(name), std::string::npos) << name << "\n" << run.out;
}

TEST(BenchCommand, MeasuresThePipelineByStage) {
  const ProgramRun run = run_tiny({"--filter", "pipeline/"});
  ASSERT_EQ(run.code, 0) << run.err;
  for (const char* stage : {"/copy ", "/8/twin/read ", "/8/twin/shade ", "/64/twin/write "})
    EXPECT_NE(run.out.find(stage), std::string::npos) << stage;
}

/// A baseline whose times are those of `file` times `factor`.
void doctor(const std::filesystem::path& file, const std::filesystem::path& doctored, double factor) {
  json all = json::parse(text_of_file(file));
  for (json& b : all["benchmarks"]) b["real_time"] = b["real_time"].get<double>() * factor;
  std::ofstream(doctored) << all;
}

TEST(BenchCommand, ComparesWithABaseline) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_kernel({"--json", folder / "b.json"}).code, 0);
  doctor(folder / "b.json", folder / "faster.json", 1e-3);
  doctor(folder / "b.json", folder / "slower.json", 1e3);
  const ProgramRun now_slower = run_kernel({"--compare", folder / "faster.json"}), now_faster = run_kernel({"--compare", folder / "slower.json"});
  EXPECT_EQ(now_slower.code, 1) << now_slower.err;
  EXPECT_NE(now_slower.out.find("slower\n"), std::string::npos);
  EXPECT_EQ(now_faster.code, 0) << now_faster.err;
  EXPECT_NE(now_faster.out.find("faster\n"), std::string::npos);
}

TEST(BenchCommand, DrawsPlots) {
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "gnuplot is not here";
  const TemporaryFolder folder;
  const ProgramRun run = run_tiny({"--filter", "kernel/.*/point/", "--brdf", "lambert,ggx,phong", "--lights", "1,2,4", "--plots", folder / "plots"});
  ASSERT_EQ(run.code, 0) << run.err;
  for (const char* name : {"roofline", "lights", "lobes"}) {
    EXPECT_NE(text_of_file(folder / (std::string("plots/") + name + ".svg")).find("</svg>"), std::string::npos) << name << run.out;
    EXPECT_EQ(text_of_file(folder / (std::string("plots/") + name + ".png")).substr(1, 3), "PNG") << name;
  }
}

TEST(BenchCommand, SaysInOneLineThatThereIsNoGnuplot) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = tiny;
  for (const std::string& a : one_kernel) arguments.push_back(a);
  arguments.insert(arguments.end(), {"--plots", folder / "plots"});
  const ProgramRun run = run_program(arguments, {}, "PATH=" + folder.path().string());
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("no figure: gnuplot is not here"), std::string::npos) << run.out;
}

TEST(BenchCommand, RefusesInOneLine) {
  const TemporaryFolder folder;
  std::ofstream(folder / "no.json") << "{";
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{{{"--filter", "("}, "is no regular expression"},
                                                                            {{"--filter", "nothing-of-this-name"}, "--filter fits no name"},
                                                                            {{"--size", "12x"}, "no size"},
                                                                            {{"--size", "0x5"}, "no size"},
                                                                            {{"--brdf", "gxx"}, "no BRDF"},
                                                                            {{"--lights", "0"}, "--lights"},
                                                                            {{"--lanes", "3"}, "--lanes"},
                                                                            {{"--compare", folder / "no.json"}, "not a benchmark's JSON"},
                                                                            {{"--compare", folder / "none.json"}, "cannot be read"}};
  for (const auto& [arguments, sentence] : wrong) {
    const ProgramRun run = run_tiny(arguments);
    EXPECT_EQ(run.code, 2) << sentence << run.err;
    EXPECT_NE(run.err.find(sentence), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

}  // namespace
}  // namespace relume
