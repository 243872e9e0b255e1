// Includes point one way through the house: EXR -> gbuffer/ -> host/ -> kernels/ -> host/ -> gbuffer/ -> EXR (DESIGN.md). A folder knows only those
// below it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> may_include{
    {"gbuffer", {"gbuffer"}},
    {"kernels", {"kernels"}},
    {"host", {"gbuffer", "host", "kernels"}},
    {"bake", {"bake", "gbuffer"}},
    {"figure", {"figure", "gbuffer"}},
    {"lab", {"figure", "gbuffer", "host", "kernels", "lab"}},
    {"bench", {"bench", "figure", "gbuffer", "host", "kernels"}},
    {"cli", {"bake", "bench", "cli", "figure", "gbuffer", "host", "lab"}},
};

TEST(Folders, IncludePointsOneWay) {
  const std::regex include("^\\s*#include\\s+\"([a-z]+)/");
  int lines = 0;
  for (const auto& [folder, allowed] : may_include)
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(RELUME_SOURCE) / folder)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (!std::regex_search(line, match, include)) continue;
        ++lines;
        if (entry.path().filename() == "roles.cpp" && line.find("kernels/parameters.h") != std::string::npos) continue;  // a bare list
        EXPECT_TRUE(allowed.contains(match[1])) << entry.path() << " includes " << match[1] << "/";
      }
    }
  EXPECT_GT(lines, 100);  // the pattern still finds includes
}

TEST(Folders, OnlyHostSeesOpenCl) {
  for (const char* folder : {"gbuffer", "cli", "kernels"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(RELUME_SOURCE) / folder)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) EXPECT_EQ(line.find("#include <CL/"), std::string::npos) << entry.path();
    }
}

TEST(Folders, FilesBeginWithWhatTheyAre) {
  for (const char* folder : {"gbuffer", "host", "cli", "kernels", "bake", "figure", "lab", "bench"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(RELUME_SOURCE) / folder)) {
      if (!std::set<std::string>{".h", ".cpp", ".cl"}.contains(entry.path().extension())) continue;
      std::ifstream in(entry.path());
      std::string line;
      std::getline(in, line);
      EXPECT_EQ(line.substr(0, 3), "// ") << entry.path() << ": the first line says what the file is";
    }
}

/// What files define for others to link to: each name with its files.
std::map<std::string, std::set<std::string>> types_of(const std::vector<std::string>& folders) {
  const std::regex opens("^(?:inline )?namespace ?([a-z:_]*) ?\\{"), closes("^\\} *// *namespace"),
      defines("^(?:struct|class|enum|enum class|union) (\\w+)(?: final)?(?: ?:[^:;].*)? ?\\{");
  std::map<std::string, std::set<std::string>> types;
  for (const std::string& folder : folders)
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(RELUME_SOURCE) / folder)) {
      if (!std::set<std::string>{".h", ".cpp"}.contains(entry.path().extension())) continue;
      std::vector<std::string> inside;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (std::regex_search(line, match, opens)) inside.push_back(match[1]);
        if (std::regex_search(line, closes) && !inside.empty()) inside.pop_back();
        if (!std::regex_search(line, match, defines) || std::find(inside.begin(), inside.end(), "") != inside.end()) continue;
        std::string name;
        for (const std::string& space : inside) name += space + "::";
        types[name + match.str(1)].insert(entry.path().string());
      }
    }
  return types;
}

/// Two of one name would share their constructors and destructors, whichever the linker keeps.
TEST(Folders, NoTypeHasTwoDefinitions) {
  const auto types = types_of({"gbuffer", "host", "bake", "figure", "lab", "bench", "cli"});
  EXPECT_GT(types.size(), 200u);  // the patterns still find types
  EXPECT_TRUE(types.contains("relume::Planes"));
  for (const auto& [name, files] : types) EXPECT_EQ(files.size(), 1u) << name << " is defined in " << *files.begin() << " and " << *files.rbegin();
}

}  // namespace
