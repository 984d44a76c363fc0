// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/operators/attach_text.h"

namespace croquis {
namespace {

using silhouette::Hold;

TEST_CASE("texts of attached pairs say how each is held") {
  const AttachText attach = read_attach_text("auto; a b,c ;d,e=0.4;f,g=apart;h,i=rest;k,l=join:0.5;m=n,o=0.3:1");
  CHECK(attach.suggested);
  REQUIRE(attach.pairs.size() == 6);
  CHECK(attach.pairs[0].a == "a b");
  CHECK(attach.pairs[0].hold == Hold::Joined);
  CHECK(attach.pairs[1].kappa == 0.4);
  CHECK(attach.pairs[2].hold == Hold::Apart);
  CHECK(attach.pairs[3].hold == Hold::Resting);
  CHECK(attach.pairs[4].kappa == silhouette::AttachedPair().kappa);
  CHECK(attach.pairs[4].blend == 0.5);
  CHECK(attach.pairs[5].a == "m=n");
  CHECK(attach.pairs[5].kappa == 0.3);
  CHECK(attach.pairs[5].blend == 1);
  CHECK_FALSE(read_attach_text("a,b").suggested);
}

TEST_CASE("texts of attached pairs read back as they were written") {
  for (const char* text : {"", "auto", "auto;a,b", "a,b=0.25;c,d=apart", "a,b=rest", "a,b=join:0.5;c,d=0.1:0.125"}) {
    CHECK(to_text(read_attach_text(text)) == text);
  }
}

TEST_CASE("of two entries for one pair the later is found, in either order of names") {
  const AttachText attach = read_attach_text("a,b=0.1;c,d;b,a=0.2");
  REQUIRE(find_pair(attach, "a", "b") != nullptr);
  CHECK(find_pair(attach, "a", "b")->kappa == 0.2);
  CHECK(find_pair(attach, "a", "c") == nullptr);
}

TEST_CASE("holds that are none are refused") {
  for (const char* wrong : {"a,b=stuck", "a,b=:", "a,b=0.5:", "a,b=0.5:x", "a,b=rest:0.5", "auto,a,b"}) {
    CHECK_THROWS_AS(read_attach_text(wrong), Error);
  }
}

}  // namespace
}  // namespace croquis
