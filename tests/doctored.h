// relume doctor on made-up files, for tests: a healthy one, and the same with a change to a patch of four pixels.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/make_gbuffer.h"
#include "tests/run_program.h"

namespace relume {

using Json = nlohmann::json;

inline MadeUpGBuffer healthy() {
  MadeUpGBuffer made;
  made.with({"albedo.R", "albedo.G", "albedo.B", "roughness", "metallic", "A", "id"});
  return made;
}

struct Doctored {
  int code;
  Json json;
  std::string err;

  /// The findings of one ailment.
  std::vector<Json> of(const std::string& ailment) const {
    std::vector<Json> found;
    for (const Json& f : json["findings"])
      if (f["ailment"] == ailment) found.push_back(f);
    return found;
  }
  std::string defects() const {
    std::string names;
    for (const Json& f : json["findings"])
      if (f["severity"] == "defect") names += f["ailment"].get<std::string>() + " ";
    return names;
  }
};

inline Doctored doctored(const std::filesystem::path& file, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"doctor", file.string(), "--json"});
  const ProgramRun run = run_program(more);
  return {run.code, Json::parse(run.out, nullptr, false), run.err};
}

inline Doctored doctored(const MadeUpGBuffer& made, const std::vector<std::string>& more = {}) {
  const TemporaryFolder folder;
  write_gbuffer(folder / "made.exr", made);
  return doctored(folder / "made.exr", more);
}

/// Four pixels of the sphere, in the middle of the frame: columns 30..31, rows 33..34.
inline bool in_patch(int x, int y) { return x >= 30 && x < 32 && y >= 33 && y < 35; }

inline void expect_patch(const Doctored& d, const std::string& ailment, const std::string& severity) {
  ASSERT_EQ(d.of(ailment).size(), 1u) << d.json.dump(1) << d.err;
  const Json f = d.of(ailment).front();
  EXPECT_EQ(f["severity"], severity);
  EXPECT_EQ(f["pixels"], 4);
  EXPECT_EQ(f["box"], Json({{"x0", 30}, {"y0", 33}, {"x1", 32}, {"y1", 35}}));
  EXPECT_TRUE(in_patch(f["example"]["x"], f["example"]["y"])) << f.dump();
  EXPECT_FALSE(f["what"].get<std::string>().empty());
  EXPECT_FALSE(f["effect"].get<std::string>().empty());
  EXPECT_EQ(d.code, severity == "defect" ? 1 : 0);
}

/// A healthy file but for what `change` does to the patch.
inline Doctored with_patch(const std::function<void(ScenePixel&)>& change) {
  MadeUpGBuffer made = healthy();
  made.pixel = [change](int x, int y, ScenePixel& pixel) {
    if (in_patch(x, y)) change(pixel);
  };
  return doctored(made);
}

}  // namespace relume
