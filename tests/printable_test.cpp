// Names from files, as they reach a terminal.
#include "gbuffer/printable.h"

#include <gtest/gtest.h>

namespace {

TEST(Printable, EscapesWhatATerminalWouldObey) {
  EXPECT_EQ(relume::printable("ViewLayer.Normal.X"), "ViewLayer.Normal.X");
  EXPECT_EQ(relume::printable("größe 法線 \U0001F600"), "größe 法線 \U0001F600");
  EXPECT_EQ(relume::printable("a\nb\x1b[31m\x7f"), "a\\nb\\x1b[31m\\x7f");
  EXPECT_EQ(relume::printable("\xff\xc0\xaf\xed\xa0\x80"), "\\xff\\xc0\\xaf\\xed\\xa0\\x80");  // no UTF-8, overlong, surrogate
  EXPECT_EQ(relume::printable("exe.\u202egnp \\ \u0085"), "exe.\\u202egnp \\\\ \\u0085");
  EXPECT_EQ(relume::printable("\xe6\xb3"), "\\xe6\\xb3");  // cut short
}

}  // namespace
