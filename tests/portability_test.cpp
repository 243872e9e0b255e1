// Portability: the same kernels under PoCL, Intel's runtime, Mesa's rusticl and Oclgrind, each in a child process; prints the tables that
// docs/portability.md keeps. RELUME_LONG=1 takes every term of every lobe, one driver after another, with nothing cached.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <future>
#include <map>
#include <sstream>

#include "gbuffer/compare.h"
#include "host/self_test.h"
#include "tests/drivers/driver.h"
#include "tests/drivers/inexact.h"
#include "tests/drivers/measure.h"
#include "tests/under_asan.h"

namespace relume {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const bool is_long = std::getenv("RELUME_LONG") != nullptr;
const std::string own_program = fs::read_symlink("/proc/self/exe");
const char* const references[] = {"principled_lobes", "half_float", "roughplastic"};

/// Why a driver is not tried; empty where it is. AddressSanitizer wants to be loaded first and watches foreign libraries' leaks: PoCL will do there.
std::string why_not(const Driver& driver) {
  if (!fs::exists(driver.icd)) return "there is no " + driver.icd.string();
  return under_asan && driver.name != "PoCL" ? "not under AddressSanitizer" : "";
}

/// What one child said, and what became of it.
struct Measurement {
  ProgramRun run;
  json device;
  std::vector<json> programs;
};

Measurement measurement_of(const Driver& driver, int programs, int lanes) {
  Measurement m;
  m.run = run_under(driver, {own_program, "--measure", is_long ? "all" : "default", std::to_string(programs), std::to_string(lanes),
                             std::to_string(driver.pixels), driver.precision});
  std::istringstream lines(m.run.out);
  for (std::string line; std::getline(lines, line);) {
    json parsed = json::parse(line, nullptr, false);
    if (parsed.is_discarded()) parsed = {{"error", line}};
    json& place = parsed.contains("device") ? m.device : m.programs.emplace_back();
    place = std::move(parsed);
  }
  return m;
}

/// The row of the table: the worst of each range over all programs.
struct Row {
  double seconds = 0, relative[2] = {};
  std::string at[2] = {"-", "-"};
  std::int64_t ulps = 0, differing = 0, values = 0;
};

Row row_of(const Measurement& m) {
  Row row;
  for (const json& program : m.programs) {
    row.seconds = std::max(row.seconds, program["seconds"].get<double>());
    for (const int k : {0, 1}) {
      const json& range = program[k == 0 ? "ordinary" : "whole"];
      if (range["relative"] > row.relative[k]) row.relative[k] = range["relative"], row.at[k] = range["at"];
      row.ulps = std::max<std::int64_t>(row.ulps, range["ulps"]);
      row.differing += range["differing"].get<std::int64_t>();
      row.values += range["values"].get<std::int64_t>();
    }
  }
  return row;
}

void print_row(const Driver& driver, const Measurement& m, const Row& row) {
  std::printf("| %s | %s, %s | %d | %zu | %lld of %lld | %lld | %.1e %s | %.1e %s | %.1f |\n", driver.name.c_str(),
              m.device["device"].get<std::string>().c_str(), m.device["driver"].get<std::string>().c_str(), m.device["lanes"].get<int>(),
              m.programs.size(), static_cast<long long>(row.differing), static_cast<long long>(row.values), static_cast<long long>(row.ulps),
              row.relative[0], row.at[0].c_str(), row.relative[1], row.at[1].c_str(), row.seconds);
}

/// Everything that a driver must do; the verdict on a driver that is there is never "skipped".
void check(const Driver& driver, const Measurement& m) {
  ASSERT_EQ(m.run.code, 0) << driver.name << ": " << m.run.out << m.run.err;
  ASSERT_TRUE(m.device.is_object()) << driver.name << ": no device: " << m.run.out << m.run.err;
  ASSERT_FALSE(m.programs.empty()) << driver.name << ": " << m.run.err;
  for (const json& program : m.programs) {
    ASSERT_FALSE(program.contains("error")) << driver.name << ": " << program["error"];
    for (const char* range : {"ordinary", "whole"}) {
      const double allowed = range == std::string("whole") ? driver.whole : driver.ordinary;
      EXPECT_LE(program[range]["relative"].get<double>(), allowed) << driver.name << ": " << program[range]["at"] << ", " << range << " parameters";
      EXPECT_EQ(program[range]["nans"], 0) << driver.name << ": " << program["lobes"];
    }
  }
  print_row(driver, m, row_of(m));
}

/// One child for each driver and lane count, all started at once: the ordinary run is bound by compilers that use one core each.
/// The long run takes one after another, so that its build times mean something.
class Portability : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new TemporaryFolder;
    fs::create_directories(*folder / "simulated");
    drivers = {pocl(),          intel(),         rusticl(), oclgrind(*folder / "oclgrind.log", *folder / "simulated", is_long ? 130 : 20),
               relaxed(pocl()), relaxed(intel())};
    for (Driver& driver : drivers) {
      const bool simulated = driver.name == "Oclgrind";
      if (is_long && !simulated) driver.settings.push_back("XDG_CACHE_HOME=" + folder->path().string());
      if (!why_not(driver).empty()) continue;
      const bool few = !is_long && driver.precision == std::string("relaxed");
      start(driver, simulated ? 2 : few ? 6 : 999, 0);
      if (driver.one_lane_too) start(driver, is_long ? 999 : 3, 1);
    }
    std::printf(
        "| driver | device, driver version | lanes | programs | values that differ | ulps | ordinary parameters | all parameters | slowest build, s "
        "|\n");
    std::printf("|---|---|---|---|---|---|---|---|---|\n");
  }
  static void TearDownTestSuite() {
    running.clear();
    delete folder;
  }

  static void start(const Driver& driver, int programs, int lanes) {
    running[driver.name].push_back(std::async(is_long ? std::launch::deferred : std::launch::async, measurement_of, driver, programs, lanes));
  }

  static const Driver& driver_named(const std::string& name) {
    return *std::find_if(drivers.begin(), drivers.end(), [&](const Driver& d) { return d.name == name; });
  }

  /// False, with a row that says so, where the driver is not on this machine.
  static bool is_there(const Driver& driver) {
    const std::string reason = why_not(driver);
    if (!reason.empty()) std::printf("| %s | skipped: %s | | | | | | | |\n", driver.name.c_str(), reason.c_str());
    return reason.empty();
  }

  static void check_driver(const std::string& name) {
    const Driver& driver = driver_named(name);
    for (std::future<Measurement>& child : running[name]) check(driver, child.get());
  }

  static inline TemporaryFolder* folder;
  static inline std::vector<Driver> drivers;
  static inline std::map<std::string, std::vector<std::future<Measurement>>> running;
};

TEST_F(Portability, Pocl) {
  if (!is_there(driver_named("PoCL"))) GTEST_SKIP();
  check_driver("PoCL");
}

TEST_F(Portability, Intel) {
  if (!is_there(driver_named("Intel"))) GTEST_SKIP() << "tests/drivers/fetch_intel build/drivers gets it";
  check_driver("Intel");
}

TEST_F(Portability, Rusticl) {
  if (!is_there(driver_named("rusticl"))) GTEST_SKIP() << "it comes with Debian's mesa-opencl-icd";
  check_driver("rusticl");
}

TEST_F(Portability, Relaxed) {
  for (const char* name : {"PoCL, relaxed", "Intel, relaxed"})
    if (is_there(driver_named(name))) check_driver(name);
}

TEST_F(Portability, OclgrindFindsNoBadAccessAndNoRace) {
  if (!is_there(driver_named("Oclgrind"))) GTEST_SKIP() << "it comes with Debian's oclgrind";
  check_driver("Oclgrind");
  EXPECT_EQ(text_of_file(*folder / "oclgrind.log"), "");
}

/// The checks are alive: a band whose output is too small must be reported.
TEST_F(Portability, OclgrindReportsWritesBeyondTheOutput) {
  if (!is_there(driver_named("Oclgrind"))) GTEST_SKIP() << "it comes with Debian's oclgrind";
  const TemporaryFolder own;
  fs::create_directories(own / "cache");
  const ProgramRun run = run_under(oclgrind(own / "log", own / "cache", 0), {own_program, "--overrun"});
  EXPECT_NE(text_of_file(own / "log").find("Invalid write"), std::string::npos) << run.out << run.err;
}

/// A device that errs as much as OpenCL allows, which GPUs may and no driver here does, stays within what the self-test lets pass.
TEST_F(Portability, TheMostInexactDeviceAllowedPassesTheSelfTest) {
  Measurement m;
  m.run.code = 0;
  inexact::InexactDevice device;
  m.device = {{"device", "C++, divide within 2.5 ulp"}, {"driver", "square root within 3 ulp"}, {"lanes", 1}};
  for (const NamedChoice& program : programs_of_all_lobes(true)) m.programs.push_back(measured(device, program, test_pixels));
  check({"emulated", {}, {}, {}, test_pixels, false, 1e-4, self_test_tolerance}, m);
}

/// dB of each reference frame, shaded through the program.
struct Frames {
  std::vector<double> db;
  std::string error;
};

Frames frames_under(const Driver& driver, const TemporaryFolder& folder) {
  Frames frames;
  for (const char* name : references) {
    const fs::path from = fs::path(RELUME_SOURCE) / "tests/data/corpus/mitsuba" / name, out = folder / (driver.name + name + ".exr");
    const ProgramRun run = run_under(driver, {RELUME_PROGRAM, "shade", from / "gbuffer.exr", "--lights", from / "rig.json", "--materials",
                                              from / "materials.json", "--device", "0", "-o", out, "--precision", driver.precision, "--quiet"});
    if (run.code != 0) return {{}, std::string(name) + ": " + run.err};
    frames.db.push_back(compare_images(out, from / "reference.exr").layers.front().psnr);
  }
  return frames;
}

/// Whole frames: what Mitsuba computed, shaded by each driver.
TEST_F(Portability, FramesMatchTheRenderer) {
  std::vector<std::pair<Driver, std::future<Frames>>> children;
  std::printf("\n| driver | principled_lobes, dB | half_float, dB | roughplastic, dB |\n|---|---|---|---|\n");
  for (const Driver& driver : drivers)
    if (driver.name != "Oclgrind" && is_there(driver))  // a frame takes a simulator minutes
      children.emplace_back(driver, std::async(std::launch::async, frames_under, driver, std::cref(*folder)));
  for (auto& [driver, child] : children) {
    const Frames frames = child.get();
    ASSERT_EQ(frames.error, "") << driver.name;
    std::printf("| %s | %.1f | %.1f | %.1f |\n", driver.name.c_str(), frames.db[0], frames.db[1], frames.db[2]);
    EXPECT_GE(frames.db[0], 100) << driver.name;
    for (std::size_t k = 0; k < frames.db.size(); ++k) {
      const json facts = json::parse(text_of_file(fs::path(RELUME_SOURCE) / "tests/data/corpus/mitsuba" / references[k] / "case.json"));
      EXPECT_GE(frames.db[k], facts["expect_db"].get<double>()) << driver.name << ", " << references[k];
    }
  }
}

/// `relume devices` under each driver names it and gives a verdict on it.
TEST_F(Portability, DevicesSaysThatEachPasses) {
  for (const Driver& driver : drivers) {
    if (!why_not(driver).empty() || driver.precision == std::string("relaxed")) continue;
    const ProgramRun run = run_under(driver, {RELUME_PROGRAM, "devices", "--json"});
    ASSERT_EQ(run.code, 0) << driver.name << ": " << run.err;
    const json devices = json::parse(run.out);
    ASSERT_EQ(devices.size(), 2u) << driver.name << " and the twin: " << run.out;
    EXPECT_EQ(devices[0]["self_test"], "passed, bit-identical to the twin") << driver.name;
  }
}

}  // namespace
}  // namespace relume

/// --measure all|default PROGRAMS LANES PIXELS exact|relaxed: the child's half (tests/drivers/measure.h).
int main(int argc, char** argv) {
  if (argc == 7 && std::string(argv[1]) == "--measure") {
    relume::measure(std::string(argv[2]) == "all", std::size_t(std::atoi(argv[3])), std::atoi(argv[4]), std::atoi(argv[5]),
                    std::string(argv[6]) == "relaxed" ? relume::Precision::relaxed : relume::Precision::exact);
    return 0;
  }
  if (argc == 2 && std::string(argv[1]) == "--overrun") {
    relume::overrun();
    return 0;
  }
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
