#include "creepcontact/base/base64.hpp"

#include <gtest/gtest.h>

#include "creepcontact/base/image.hpp"

namespace creepcontact {
namespace {

TEST(Base64, AsInRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xFF\xFE\x00", 3)), "//4A");
}

TEST(Base64, AndBack) {
  for (const std::string& bytes : {std::string(), std::string("f"), std::string("fo"), std::string("\xFF\xFE\x00 ", 4)})
    EXPECT_EQ(from_base64(base64(bytes)), bytes);
  for (const char* wrong : {"Z", "Zg=", "Zg ==", "Z===", "\"><b>", "Zm9v\n"}) EXPECT_FALSE(from_base64(wrong)) << wrong;
}

TEST(Image, KnownByItsContent) {
  EXPECT_EQ(image_type("\x89PNG\r\n\x1A\n...."), "image/png");
  EXPECT_EQ(image_type("\xFF\xD8\xFF\xE0"), "image/jpeg");
  EXPECT_EQ(image_type("<?xml version=\"1.0\"?>\n<!-- a mark -->\n<svg xmlns=\"...\"/>"), "image/svg+xml");
  for (const char* other : {"", "GIF89a", "<html><body></body></html>", "svg <svg>", "BM"})
    EXPECT_EQ(image_type(other), "") << other;
}

TEST(Image, WhatIsNoFileIsTold) {
  EXPECT_NE(read_image("missing.png").failure, "");
  EXPECT_NE(read_image("/dev/zero").failure, "");
  EXPECT_NE(read_image(".").failure, "");
}

}  // namespace
}  // namespace creepcontact
