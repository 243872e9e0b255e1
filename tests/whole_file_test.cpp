// Whole files: whatever happens on the way, there is the old file or the new one, and nothing beside it.
#include "gbuffer/whole_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/files.h"

namespace {

namespace fs = std::filesystem;
using relume::Error;
using relume::ErrorKind;
using relume::WholeFile;

/// The message of an Error{output}.
std::string refusal(const std::function<void()>& work) { return message_of(work, ErrorKind::output); }

TEST(WholeFile, FileThatAppearsMeanwhileIsNotReplaced) {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "a.exr";
  WholeFile whole(file, false);
  whole.write("new", 3);
  put(file, "theirs");
  EXPECT_NE(refusal([&] { whole.commit(); }).find("exists"), std::string::npos);
  EXPECT_EQ(contents(file), "theirs");
}

TEST(WholeFile, WritesSeeksAndKeepsTheMode) {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "a";
  const std::string large(3000000, 'x');
  put(file, "old");
  chmod(file.c_str(), 0640);
  WholeFile whole(file, true);
  whole.write("abc", 3);
  whole.write(large.data(), large.size());
  EXPECT_EQ(whole.position(), 3000003u);
  whole.seek(1);
  whole.write("B", 1);
  EXPECT_EQ(whole.position(), 2u);
  bool verified = false;
  whole.commit([&](const fs::path& temporary) { verified = contents(temporary) == "aBc" + large; });
  EXPECT_TRUE(verified);
  EXPECT_EQ(contents(file), "aBc" + large);
  struct stat status {};
  stat(file.c_str(), &status);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(WholeFile, RefusedVerificationLeavesNothing) {
  const TemporaryFolder folder;
  {
    WholeFile whole(folder.path / "a", false);
    whole.write("abc", 3);
    refusal([&] { whole.commit([](const fs::path&) { throw Error(ErrorKind::output, "no"); }); });
  }
  EXPECT_TRUE(names_in(folder.path).empty());
}

TEST(WholeFile, InterruptRemovesEveryTemporary) {
  const TemporaryFolder folder;
  put(folder.path / "a", "old");
  WholeFile a(folder.path / "a", true), b(folder.path / "b", false), again(folder.path / "b", false);
  EXPECT_EQ(names_in(folder.path).size(), 4u);
  relume::remove_temporaries();
  EXPECT_EQ(names_in(folder.path), std::set<std::string>{"a"});
}

TEST(WholeFile, LeftoverOfAKilledProcessIsNoObstacle) {
  const TemporaryFolder folder;
  const fs::path leftover = folder.path / (".a." + std::to_string(getpid()) + ".tmp");
  put(leftover, "left");
  WholeFile whole(folder.path / "a", false);
  whole.write("new", 3);
  whole.commit();
  EXPECT_EQ(contents(folder.path / "a"), "new");
  EXPECT_EQ(contents(leftover), "left");
}

TEST(WholeFile, LinksAreFollowedAndOtherThingsRefused) {
  const TemporaryFolder folder;
  put(folder.path / "target", "old");
  fs::create_symlink("target", folder.path / "link");
  {
    WholeFile whole(folder.path / "link", true);
    whole.write("new", 3);
    whole.commit();
  }
  EXPECT_TRUE(fs::is_symlink(folder.path / "link"));
  EXPECT_EQ(contents(folder.path / "target"), "new");
  fs::create_symlink("nowhere", folder.path / "dangling");
  ASSERT_EQ(mkfifo((folder.path / "pipe").c_str(), 0600), 0);
  const auto attempt = [](const fs::path& file, bool overwrite) { return [=] { const WholeFile whole(file, overwrite); }; };
  refusal(attempt(folder.path / "link", false));
  refusal(attempt(folder.path / "dangling", true));
  EXPECT_NE(refusal(attempt(folder.path / "pipe", true)).find("regular"), std::string::npos);
  EXPECT_NE(refusal(attempt("/dev/full", true)).find("regular"), std::string::npos);
  EXPECT_NE(refusal(attempt(folder.path, true)).find("regular"), std::string::npos);
  EXPECT_NE(refusal(attempt(folder.path / "none" / "a.exr", false)).find("no such folder"), std::string::npos);
  refusal(attempt("", false));
  refusal(attempt(folder.path / std::string(300, 'n'), false));
}

}  // namespace
