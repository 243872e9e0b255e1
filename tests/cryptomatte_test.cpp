// Cryptomattes: layers in every spelling, by name alone, in parts, and with defects.
#include "gbuffer/cryptomatte.h"

#include <gtest/gtest.h>

#include "tests/made_cryptomatte.h"
#include "tests/make_gbuffer.h"
#include "tests/refusal.h"
#include "tests/run_program.h"

namespace relume {
namespace {

std::vector<Cryptomatte> found_in(const std::filesystem::path& path) {
  const ExrFile file(path);
  return cryptomattes_of(file, understand(file, {}));
}

TEST(Cryptomatte, LayersInEverySpelling) {
  struct Spelling {
    const char *name, *r, *g, *b, *a;
  };
  for (const Spelling& s :
       {Spelling{"CryptoObject", "CryptoObject00.R", "CryptoObject00.G", "CryptoObject00.B", "CryptoObject00.A"},
        Spelling{"crypto_object", "crypto_object00.r", "crypto_object00.g", "crypto_object00.b", "crypto_object00.a"},
        Spelling{"uCryptoAsset", "uCryptoAsset00.red", "uCryptoAsset00.green", "uCryptoAsset00.blue", "uCryptoAsset00.alpha"},
        Spelling{"ActorHitProxyMask", "ActorHitProxyMask00.R", "ActorHitProxyMask00.G", "ActorHitProxyMask00.B", "ActorHitProxyMask00.A"},
        Spelling{"ViewLayer.Crypto", "ViewLayer_Crypto00.red", "ViewLayer_Crypto00.green", "ViewLayer_Crypto00.blue", "ViewLayer_Crypto00.alpha"}}) {
    const MadeUpExr made({{"", "", with_geometry({s.r, s.g, s.b, s.a})}}, 8, 2, Frame8::value, metadata(s.name, ""));
    const auto found = found_in(made.file);
    ASSERT_EQ(found.size(), 1u) << s.name;
    EXPECT_EQ(found[0].name, s.name);
    EXPECT_EQ(found[0].ranks(), 2u);
    EXPECT_EQ(found[0].levels[0].channels, (std::vector<std::string>{s.r, s.g, s.b, s.a}));
    EXPECT_EQ(found[0].defect, "");
  }
}

TEST(Cryptomatte, WithoutMetadataByItsName) {
  const MadeUpExr made(
      {{"", "",
        with_geometry({"CryptoMaterial00.R", "CryptoMaterial00.G", "CryptoMaterial01.R", "CryptoMaterial01.G", "CryptoMaterial01.B",
                       "CryptoMaterial01.A", "CryptoMaterial.R", "CryptoMaterial.G", "CryptoMaterial.B", "other00.R", "other00.G"})}},
      8, 2, Frame8::value);
  const auto found = found_in(made.file);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "CryptoMaterial");
  EXPECT_EQ(found[0].ranks(), 3u);
  for (const char* meant : {"CryptoMaterial", "cryptomaterial", "crypto_material", "CryptoMaterial00", "Crypto Material 01"})
    EXPECT_TRUE(goes_by(found[0], meant)) << meant;
  for (const char* other : {"Crypto", "material", "", "CryptoObject"}) EXPECT_FALSE(goes_by(found[0], other)) << other;
}

TEST(Cryptomatte, APartForEachLevel) {
  const MadeUpExr made({{"geometry", "", geometry}, {"crypto_object01", "", {"R", "G", "B", "A"}}, {"crypto_object00", "", {"R", "G", "B", "A"}}}, 8,
                       2, Frame8::value, metadata("crypto_object", ""));
  const auto found = found_in(made.file);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].levels[0].part, 2);
  EXPECT_EQ(found[0].levels[1].part, 1);
  EXPECT_EQ(found[0].header_part, 0);
}

TEST(Cryptomatte, DefectsAreSaid) {
  const MadeUpExr whole({{"", "", with_geometry({"Crypto00.R:uint", "Crypto00.G"})}}, 8, 2, Frame8::value);
  EXPECT_EQ(found_in(whole.file)[0].defect, "channel \"Crypto00.R\" is uint: its ids are lost (a Cryptomatte's are the bits of 32-bit floats)");
  const MadeUpExr headless({{"", "", with_geometry({"Crypto01.R", "Crypto01.G"})}}, 8, 2, Frame8::value);
  EXPECT_EQ(found_in(headless.file)[0].defect, "layer \"Crypto00\", which has its first ranks, is missing");
  const MadeUpExr converted({{"", "", with_geometry({"Crypto00.R", "Crypto00.G"})}}, 8, 2, Frame8::value, [](Imf::Header& header) {
    metadata("Crypto", "")(header);
    header.insert("cryptomatte/1a2b3c4/conversion", Imf::StringAttribute("uint32_to_\nhalf"));
  });
  EXPECT_EQ(found_in(converted.file)[0].defect, "its ids are stored as \"uint32_to_\\nhalf\" (uint32_to_float32 is known)");
  const TemporaryFolder folder;
  MadeUpGBuffer made;
  made.half = true;
  made.with({"Crypto00.R", "Crypto00.G"});
  write_gbuffer(folder / "half.exr", made);
  EXPECT_EQ(found_in(folder / "half.exr")[0].defect,
            "channel \"Crypto00.R\" is half: its ids are lost (a Cryptomatte's are the bits of 32-bit floats)");
}

}  // namespace
}  // namespace relume
