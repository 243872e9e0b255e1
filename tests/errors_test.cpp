// Every way to fail, provoked once through the program: the exit code, the one line on stderr, and nothing left in the folder.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <regex>
#include <set>
#include <thread>

#include "tests/make_gbuffer.h"
#include "tests/run_program.h"

namespace relume {
namespace {

/// A folder with a good G-buffer and rig, and a folder for outputs.
class Errors : public testing::Test {
 protected:
  void SetUp() override {
    MadeUpGBuffer made;
    made.with({"albedo.R", "albedo.G", "albedo.B", "roughness", "id"});
    write_gbuffer(in("good.exr"), made);
    put("rig.json", R"({"relume": 1, "lights": [{"type": "point", "position": [2, 3, 4], "intensity": [40, 38, 35]}]})");
  }

  std::string in(const std::string& name) const { return (inputs_ / name).string(); }
  std::string out(const std::string& name = "out.exr") const { return (outputs_ / name).string(); }
  void put(const std::string& name, const std::string& text) const { std::ofstream(inputs_ / name, std::ios::binary) << text; }
  void put_scene(const std::string& name, std::vector<std::string> channels, bool camera = true) const {
    MadeUpGBuffer made;
    made.channels = std::move(channels);
    made.camera_in_header = camera;
    write_gbuffer(in(name), made);
  }
  std::set<std::string> left() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(outputs_.path())) names.insert(entry.path().filename());
    return names;
  }

  std::vector<std::string> arguments(std::vector<std::string> options, const std::string& gbuffer = "good.exr",
                                     const std::string& rig = "rig.json") const {
    std::vector<std::string> all{"shade", in(gbuffer), "--lights", in(rig), "-o", out(), "--device", "twin"};
    all.insert(all.end(), options.begin(), options.end());
    return all;
  }

  /// The program must end so, saying exactly this line; FOLDER stands for the inputs' folder, OUT for the outputs', `...` for anything.
  void expect(const std::vector<std::string>& all, int code, const std::string& line, const std::string& before = {}) const {
    const ProgramRun run = run_program(all, {}, before);
    EXPECT_EQ(run.code, code) << line << "\nsaid: " << run.err;
    EXPECT_EQ(run.out, "");
    std::string pattern;
    const std::string wanted = "relume: " + line + "\n";
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (wanted.compare(i, 3, "...") == 0) {
        pattern += "[^\n]*";
        i += 2;
      } else if (wanted.compare(i, 6, "FOLDER") == 0) {
        pattern += inputs_.path().string();
        i += 5;
      } else if (wanted.compare(i, 3, "OUT") == 0) {
        pattern += outputs_.path().string();
        i += 2;
      } else {
        if (std::string("\\^$.|?*+()[]{}").find(wanted[i]) != std::string::npos) pattern += '\\';
        pattern += wanted[i];
      }
    }
    EXPECT_TRUE(std::regex_match(run.err, std::regex(pattern))) << "wanted: " << wanted << "said:   " << run.err;
    EXPECT_TRUE(left().empty()) << *left().begin();
  }
  void expect(std::vector<std::string> options, const std::string& line, int code = 2) const { expect(arguments(std::move(options)), code, line); }

  TemporaryFolder inputs_, outputs_;
};

TEST_F(Errors, FilesThatAreNoGBuffers) {
  expect(arguments({}, "none.exr"), 2, "FOLDER/none.exr: no such file");
  expect(arguments({}, "."), 2, "FOLDER/.: is a folder, not a file");
  expect(arguments({}, "rig.json"), 2, "FOLDER/rig.json: not an OpenEXR file");
  const std::string whole = text_of_file(in("good.exr"));
  put("cut.exr", whole.substr(0, whole.size() / 2));
  expect(arguments({}, "cut.exr"), 2, "FOLDER/cut.exr: part 0: damaged pixel data: the file ends early");
  put("header.exr", whole.substr(0, 200));
  expect(arguments({}, "header.exr"), 2, "FOLDER/header.exr: attribute \"channels\" claims ... bytes of ... left in the file");
  put("empty.exr", "");
  expect(arguments({}, "empty.exr"), 2, "FOLDER/empty.exr: not an OpenEXR file");
}

TEST_F(Errors, HeadersThatWouldMisleadTheLibrary) {
  const std::string folder = RELUME_SOURCE "/tests/data/hostile/", place = folder + "second_channel_list.exr";
  expect({"inspect", place}, 2, place + ": attribute \"nnels\" is a channel list (only \"channels\" may be)");
  std::string many("\x76\x2f\x31\x01\2\0\0\0", 8);
  for (int i = 0; i <= 100000; ++i) many += std::to_string(i) + std::string("\0int\0\4\0\0\0\0\0\0\0", 13);
  put("many.exr", many);
  expect({"inspect", in("many.exr")}, 2, "FOLDER/many.exr: more than 100000 attributes");
  const std::string block = folder + "block_of_1.6_GB.exr";
  expect({"inspect", block}, 4,
         block + ": a block of rows decodes to 1610612736 bytes (at most 536870912: ReadLimits::max_block_bytes; codecs with ...");
}

TEST_F(Errors, LayersThatAreNotThere) {
  put_scene("flat.exr", {"albedo.R", "albedo.G", "albedo.B", "roughness"});
  expect(arguments({}, "flat.exr"), 2, "FOLDER/flat.exr: part 0: no normal layer (looked for ...; --map normal=LAYER names one)");
  put_scene("nowhere.exr", {"N.X", "N.Y", "N.Z"});
  expect(arguments({}, "nowhere.exr"), 2, "FOLDER/nowhere.exr: part 0: no position or depth layer (looked for ...; --map position=LAYER names one)");
  expect({"--map", "normal=Nope"}, "FOLDER/good.exr: no layer \"Nope\" for normal with three components (there are: N, P, albedo)");
  expect({"--map", "roughness=Nope"}, "FOLDER/good.exr: no layer \"Nope\" for roughness (there are: N, P, albedo, id, roughness)");
  expect({"--map", "N"}, "--map N: is not ROLE=LAYER (--map normal=N)");
  expect({"--map", "normals=N"}, "--map: no role \"normals\" (has: position, normal, ...)");
  expect({"--part", "7"}, "FOLDER/good.exr: no part 7 (there are 1, counted from 0)");
  expect({"--view-layer", "beauty"}, "FOLDER/good.exr: no view layer \"beauty\" (the file has none)");
  expect({"--view", "left"}, "FOLDER/good.exr: no view \"left\" (the file has none)");
  expect({"--convention", "maya"}, "FOLDER/good.exr: no convention \"maya\" (there are: blender, ...)");
}

TEST_F(Errors, LobesAndParameters) {
  expect({"--specular", "gxx"}, "command line: \"specular\": no lobe \"gxx\" (has: auto, none, ..., ggx, ...)");
  expect({"--diffuse", "lambent"}, "command line: \"diffuse\": no lobe \"lambent\" (has: auto, none, lambert, ...)");
  expect({"--set", "roughness=2"}, "--set roughness=2: 2 is out of range (0..1)");
  expect({"--set", "roughness=abc"}, "--set roughness=abc: \"abc\" is not a number");
  expect({"--set", "roughness"}, "--set roughness: must be PARAM=VALUE");
  expect({"--set", "rouhgness=1"}, "--set rouhgness=1: no parameter \"rouhgness\" (has: albedo, ...)");
  expect({"--diffuse", "lambert", "--specular", "ggx", "--set", "exponent=32"},
         "command line: \"exponent\": not a parameter of diffuse lambert and specular ggx with fresnel schlick (has: albedo, alpha, roughness, f0, "
         "...)");
  expect({"--layers", "total,beauty"}, "--layers: no layer \"beauty\" (has: total, diffuse, specular, ambient, lights)");
}

TEST_F(Errors, RigAndMaterialFiles) {
  const auto with_rig = [&](const std::string& text) {
    put("bad.json", text);
    return arguments({}, "good.exr", "bad.json");
  };
  expect(arguments({}, "good.exr", "none.json"), 2, "FOLDER/none.json: no such file");
  expect(with_rig("{\"relume\": 1,\n \"lights\": [\n"), 2, "FOLDER/bad.json:2: not JSON: unexpected end of input...");
  expect(with_rig("{\"relume\": 1,\n \"lights\": [\n  {\"type\": \"point\", \"colour\": [1, 1, 1]}]}"), 2,
         "FOLDER/bad.json:3: lights[0]: unknown key \"colour\" (has: type, name, ...)");
  put("materials.json", R"({"relume": 1, "ids": "id", "materials": {"1": {"specular": "none"}}})");
  expect({"--materials", in("materials.json")}, "FOLDER/good.exr: no material for object id 2 (a \"default\" entry would take them)");
  put("materials.json", R"({"relume": 1, "ids": "shape", "materials": {"1": {"specular": "none"}}})");
  expect({"--materials", in("materials.json")}, "FOLDER/good.exr: no layer \"shape\" (there are: N, P, albedo, id, roughness)");
  put("materials.json", "{\"relume\": 1, \"materials\": {\n\"1\": {\"specular\": \"gxx\"}}}");
  expect({"--materials", in("materials.json")}, "FOLDER/materials.json:2: materials[\"1\"]: \"specular\": no lobe \"gxx\" (has: ...)");
}

TEST_F(Errors, Devices) {
  std::vector<std::string> all = arguments({});
  all.back() = "h100";
  expect(all, 3, "no OpenCL device named \"h100\" (found: ...; --device twin needs none)");
  // No driver at all: a device asked for by name is an error, the default falls back to the twin and says so.
  const std::string nothing = "OCL_ICD_VENDORS=" + shell_quoted(outputs_.path().string() + "/") + " OCL_ICD_FILENAMES= ";
  all.back() = "gpu";
  expect(all, 3, "no OpenCL device named \"gpu\" (found: none; --device twin needs none)", nothing);
  all.resize(all.size() - 2);
  const ProgramRun run = run_program(all, {}, nothing);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err.find("note: no OpenCL device (found: none; --device twin needs none); shading on the C++ twin instead\n"), 0u) << run.err;
  EXPECT_EQ(left(), std::set<std::string>{"out.exr"});
}

TEST_F(Errors, Outputs) {
  std::vector<std::string> all = arguments({});
  all[5] = out("none/out.exr");
  expect(all, 5, "OUT/none/out.exr: no such folder");
  all[5] = "/";
  expect(all, 5, "/: names no file");
  expect(arguments({}), 5, "OUT/out.exr: the file grows beyond what this process or disk allows", "ulimit -f 8;");
  expect(arguments({"--png", out("none/out.png")}), 5, "OUT/none/out.png: no such folder");

  // What is there stays as it was, to the last bit.
  std::ofstream(outputs_ / "out.exr") << "mine";
  const ProgramRun refused = run_program(arguments({}));
  EXPECT_EQ(refused.code, 5);
  EXPECT_EQ(refused.err, "relume: " + out() + ": exists (--overwrite replaces it)\n");
  EXPECT_EQ(text_of_file(out()), "mine");
  const ProgramRun full = run_program(arguments({"--overwrite"}), {}, "ulimit -f 8;");
  EXPECT_EQ(full.code, 5) << full.err;
  EXPECT_EQ(text_of_file(out()), "mine");
  EXPECT_EQ(left(), std::set<std::string>{"out.exr"});
  std::filesystem::remove(outputs_ / "out.exr");
  std::ofstream(outputs_ / "out.png") << "mine";
  const ProgramRun picture = run_program(arguments({"--png", out("out.png")}));
  EXPECT_EQ(picture.code, 5);
  EXPECT_EQ(picture.err, "relume: " + out("out.png") + ": exists (--overwrite replaces it)\n");
  EXPECT_EQ(text_of_file(out("out.png")), "mine");
  EXPECT_EQ(left(), std::set<std::string>{"out.png"});
}

TEST_F(Errors, MemoryAndWindows) {
  expect({"--memory", "1K"}, "FOLDER/good.exr: one row needs ... bytes of planes; --memory allows 1024", 4);
  for (const char* wrong : {"huge", "-1", "0", "1T", "nan", "inf"})
    expect({std::string("--memory=") + wrong}, std::string("--memory ") + wrong + ": is not a size (512M, 2G)");
  for (const char* wrong : {"1", "-0.1", "nan", "1%", "few"})
    expect({std::string("--error=") + wrong}, std::string("--error ") + wrong + ": is not a share, at least 0 and below 1 (0: exact; 0.01: within 1%)");
  const std::string form = ": is not X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1 (X1, Y1: one past the last)";
  for (const char* wrong : {"5,5,5,9", "a", "1,2,3", "1,2,3,4,5"}) expect({"--crop", wrong}, std::string("--crop ") + wrong + form);
  expect({"--crop", "500,5,600,9"}, "FOLDER/good.exr: --crop lies outside the data window");
}

TEST_F(Errors, Cameras) {
  put_scene("blind.exr", {"P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z"}, false);
  MadeUpGBuffer made;
  made.camera_in_header = false;
  made.pixel = [](int, int, ScenePixel& pixel) { pixel.position = {1, 2, 3}; };
  write_gbuffer(in("blind.exr"), made);
  expect(arguments({}, "blind.exr"), 2,
         "FOLDER/blind.exr: no camera: none in the header or the rig, and the positions do not determine one (--camera FILE names a rig, a glTF or "
         "another EXR)");
  expect({"--camera", in("rig.json")},
         "FOLDER/rig.json: no camera in it (a rig with \"camera\", a glTF with a camera node, or an EXR with camera attributes has one)");
  expect({"--camera", in("none.json")}, "FOLDER/none.json: no such file");
}

TEST_F(Errors, Usage) {
  expect({}, 2, "no command given (has: shade, ...; relume --help)");
  expect({"shad"}, 2, "no command \"shad\" (has: shade, ...; relume --help)");
  expect({"shade"}, 2, "gbuffer is required (relume --help, relume COMMAND --help)");
  expect({"--exposre", "1"}, "The following argument...--exposre...");
  expect({"--compression", "lzma"}, "--compression: lzma not in {none,rle,...} (relume --help, relume COMMAND --help)");
}

TEST_F(Errors, HostileNamesComeOutEscaped) {
  const std::string name = "bad\nname\x1b[31m";
  put_scene("hostile.exr", {"P.X", "P.Y", "P.Z", name + ".X", name + ".Y", name + ".Z"});
  expect(arguments({"--map", "normal=Nope"}, "hostile.exr"), 2,
         R"(FOLDER/hostile.exr: no layer "Nope" for normal with three components (there are: P, bad\nname\x1b[31m))");
  expect(arguments({"--map", "normal=No\x1b[1mpe"}), 2,
         R"(FOLDER/good.exr: no layer "No\x1b[1mpe" for normal with three components (there are: N, P, albedo))");
  expect(arguments({}, "none\x1b[1m.exr"), 2, R"(FOLDER/none\x1b[1m.exr: no such file)");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"inspect", in("hostile.exr"), "--map", "normal=" + name},
        {"shade", in("hostile.exr"), "-l", in("rig.json"), "-o", out(), "--device", "twin", "--map", "normal=" + name}}) {
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ((run.out + run.err).find('\x1b'), std::string::npos);
  }
}

/// A signal while the shading is under way: the temporary beside the output goes too.
TEST_F(Errors, Interrupts) {
  std::string lights;
  for (int k = 0; k < 50000; ++k) lights += (k ? "," : "") + std::string(R"({"type": "point", "position": [2, 3, 4], "intensity": [1, 1, 1]})");
  put("many.json", R"({"relume": 1, "lights": [)" + lights + "]}");
  write_gbuffer(in("big.exr"), MadeUpGBuffer::of_size(2048, 2048));  // 2e11 pixel*lights: minutes
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    for (const bool twin : {true, false}) {  // and the best device there is
      std::vector<std::string> all = arguments({"--quiet"}, "big.exr", "many.json");
      if (!twin) all.erase(all.begin() + 6, all.begin() + 8);
      const pid_t child = fork();
      ASSERT_GE(child, 0);
      if (child == 0) {
        std::vector<char*> words{const_cast<char*>(RELUME_PROGRAM)};
        for (std::string& word : all) words.push_back(word.data());
        words.push_back(nullptr);
        execv(RELUME_PROGRAM, words.data());
        _exit(127);
      }
      for (int i = 0; i < 1000 && left().empty(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
      EXPECT_EQ(left().size(), 1u) << "no output was begun within 20 s";
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
      kill(child, signal);
      int status = 0;
      waitpid(child, &status, 0);
      EXPECT_TRUE(WIFEXITED(status));
      EXPECT_EQ(WEXITSTATUS(status), 128 + signal) << (twin ? "twin" : "default device");
      EXPECT_TRUE(left().empty()) << *left().begin();
    }
  }
}

}  // namespace
}  // namespace relume
