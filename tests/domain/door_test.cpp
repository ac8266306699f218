// Every verdict of the door on the smallest input that earns it, with the place it names.
#include <limits>

#include "catch.h"
#include "domain/domain.h"
#include "domain_shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

Error refused(const DomainInput& input, const DomainOptions& options = {}) {
  const auto domain = make_domain(input, options);
  REQUIRE_FALSE(domain.has_value());
  INFO(domain.error().message);
  CHECK(domain.error().message.size() > 20);
  return domain.error();
}

}  // namespace

TEST_CASE("numbers that are none are refused with their place") {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto input = square_with_holes();
    input.regions[0].loops[1][2].y = bad;
    const Error error = refused(input);
    CHECK(error.code == ErrorCode::non_finite);
    CHECK(error.where.loop == 1);
    CHECK(error.where.edge == 2);
  }
}

TEST_CASE("nothing, and regions without loops, are empty") {
  CHECK(refused({}).code == ErrorCode::empty);
  CHECK(refused(one_region({})).code == ErrorCode::empty);
  const Error error = refused(regions_of({{rectangle(0, 0, 1, 1)}, {}}));
  CHECK(error.code == ErrorCode::empty);
  CHECK(error.where.region == 1);
}

TEST_CASE("loops need three distinct points and an area") {
  for (const Loop& loop :
       {Loop{}, Loop{{5, 5}}, Loop{{5, 5}, {6, 6}}, Loop{{5, 5}, {6, 5}, {5, 5}}}) {
    const Error error = refused(one_region({rectangle(0, 0, 10, 10), loop}));
    CHECK(error.code == ErrorCode::too_few_points);
    CHECK(error.where.loop == 1);
  }
  const Error error = refused(one_region({rectangle(0, 0, 10, 10), {{1, 1}, {3, 3}, {2, 2}}}));
  CHECK(error.code == ErrorCode::zero_area);
  CHECK(error.where.loop == 1);
}

TEST_CASE("a bow-tie names both edges and the crossing") {
  const Error error = refused(one_region({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}));
  CHECK(error.code == ErrorCode::self_intersection);
  CHECK(error.where.edge == 0);
  CHECK(error.where.other_edge == 2);
  CHECK(error.where.x == lpq_test::Approx(2));
  CHECK(error.where.y == lpq_test::Approx(2));
  CHECK(error.message.find("edge 2 of loop 0") != std::string::npos);
}

TEST_CASE("edges are numbered as given, repeated points included") {
  const Error error =
      refused(one_region({{{0, 0}, {0, 0}, {4, 4}, {4, 4}, {4, 4}, {4, 0}, {0, 4}, {0, 0}}}));
  CHECK(error.code == ErrorCode::self_intersection);
  CHECK(error.where.edge == 1);
  CHECK(error.where.other_edge == 5);
}

TEST_CASE("spikes and shared pieces of line are overlaps") {
  Error error = refused(one_region({{{0, 0}, {4, 0}, {4, 4}, {4, 6}, {4, 4}, {0, 4}}}));
  CHECK(error.code == ErrorCode::overlapping_edges);
  CHECK(error.where.edge == 2);
  CHECK(error.where.other_edge == 3);
  error = refused(one_region({rectangle(0, 0, 10, 10), rectangle(0, 3, 2, 5)}));
  CHECK(error.code == ErrorCode::overlapping_edges);
  CHECK(error.where.other_loop == 1);
}

TEST_CASE("loops of one region may not touch") {
  Error error = refused(one_region({rectangle(0, 0, 10, 10), {{0, 5}, {2, 4}, {2, 6}}}));
  CHECK(error.code == ErrorCode::touching);
  CHECK(error.where.x == 0);
  CHECK(error.where.y == 5);
  error = refused(one_region({rectangle(0, 0, 10, 10), {{0, 0}, {2, 1}, {1, 2}}}));
  CHECK(error.code == ErrorCode::touching);
  error = refused(one_region({{{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}}));
  CHECK(error.code == ErrorCode::touching);
  CHECK(error.where.edge == 1);
  CHECK(error.where.other_edge == 4);
}

TEST_CASE("holes lie inside the outer loop and outside each other") {
  Error error = refused(one_region({rectangle(0, 0, 10, 10), rectangle(20, 0, 21, 1)}));
  CHECK(error.code == ErrorCode::hole_outside);
  CHECK(error.where.loop == 1);
  error =
      refused(one_region({rectangle(0, 0, 10, 10), rectangle(2, 2, 8, 8), rectangle(3, 3, 4, 4)}));
  CHECK(error.code == ErrorCode::nested_or_duplicate_hole);
  CHECK(error.where.loop == 2);
  CHECK(error.where.other_loop == 1);
  error =
      refused(one_region({rectangle(0, 0, 10, 10), rectangle(2, 2, 8, 8), rectangle(2, 2, 8, 8)}));
  CHECK(error.code == ErrorCode::nested_or_duplicate_hole);
}

TEST_CASE("the outer loop is the largest, or the first if the caller says so") {
  const auto input = one_region({rectangle(3, 3, 7, 7), rectangle(0, 0, 10, 10)});
  CHECK(make_domain(input).has_value());
  CHECK(refused(input, {.outer_first = true}).code == ErrorCode::hole_outside);
}

TEST_CASE("repeated points are merged with a warning, or refused in strict mode") {
  auto input = one_region({{{0, 0}, {4, 0}, {4, 0}, {4, 4}, {0, 4}}});
  const auto domain = make_domain(input);
  REQUIRE(domain.has_value());
  CHECK(domain->points.size() == 4);
  REQUIRE(domain->warnings.size() == 1);
  CHECK(domain->warnings[0].where.loop == 0);
  CHECK(domain->warnings[0].where.edge == 1);
  CHECK(refused(input, {.strict = true}).code == ErrorCode::duplicate_point);
  input = one_region({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}});
  CHECK(make_domain(input, {.strict = true}).has_value());
  CHECK(make_domain(input)->warnings.empty());
}

TEST_CASE("of many repeated points a few are told, and how many more there are") {
  auto input = one_region({rectangle(0, 0, 10, 10)});
  input.regions[0].loops[0].insert(input.regions[0].loops[0].begin(), 1000, {0, 0});
  for (int i = 0; i < 501; ++i) input.points.push_back({{5, 5}, ""});
  const auto domain = make_domain(input);
  REQUIRE(domain.has_value());
  REQUIRE(domain->warnings.size() == 21);
  CHECK(domain->warnings[19].where.edge == 19);
  CHECK(domain->warnings.back().code == ErrorCode::duplicate_point);
  CHECK(domain->warnings.back().message == "And 1480 more of this kind.");
}

TEST_CASE("coordinates of very different magnitude are refused, not rounded") {
  auto input = one_region({rectangle(0, 0, 1e300, 1e300)});
  CHECK(make_domain(input).has_value());
  input.regions[0].loops[0][0] = {1e-300, 0};
  CHECK(refused(input).code == ErrorCode::lost_precision);
  input = one_region({rectangle(-1.7e308, 0, 1.7e308, 1)});
  CHECK(refused(input).code == ErrorCode::lost_precision);
  CHECK(make_domain(one_region({rectangle(0, 0, 1e-300, 1e-300)})).has_value());
}

TEST_CASE("sizes and tags must fit") {
  auto input = square_with_holes();
  input.h = -1;
  CHECK(refused(input).code == ErrorCode::bad_size);
  input.h = std::numeric_limits<double>::quiet_NaN();
  CHECK(refused(input).code == ErrorCode::non_finite);
  input.h = 0;
  using TagLists = std::vector<std::vector<std::string>>;
  const std::size_t loops = input.regions[0].loops.size();
  for (const TagLists& wrong : {TagLists{{"a", "b", "c", "d", "e"}}, {{"a", "b"}}, {{}, {"a"}}}) {
    input.regions[0].tags = wrong;
    CHECK(refused(input).code == ErrorCode::bad_option);
    CHECK(refused(input).where.loop == static_cast<Index>(wrong.size() - 1));
  }
  input.regions[0].tags = TagLists(loops + 1);
  input.regions[0].tags.back() = {"a"};
  CHECK(refused(input).message.find("a list of tags per loop") != std::string::npos);
  for (const TagLists& right : {TagLists{}, {{}}, {{"a", "b", "c", ""}}}) {
    input.regions[0].tags = right;
    CHECK(make_domain(input));
  }
  // The first point once more at the end makes no edge.
  input.regions[0].loops[0].push_back(input.regions[0].loops[0].front());
  for (const TagLists& right : {TagLists{{"a", "b", "c", "d"}}, {{"a", "b", "c", "d", ""}}}) {
    input.regions[0].tags = right;
    CHECK(make_domain(input));
  }
}

TEST_CASE("regions share edges and corners, nothing else") {
  const Loop left = rectangle(0, 0, 1, 1), right = rectangle(1, 0, 2, 1);
  auto domain = make_domain(regions_of({{left}, {right}}));
  REQUIRE(domain.has_value());
  CHECK(domain->points.size() == 6);
  CHECK(domain->segments.size() == 7);
  int shared = 0;
  for (const Segment& s : domain->segments) shared += s.left != none && s.right != none;
  CHECK(shared == 1);
  // One corner in common; a hole filled by another region; regions apart.
  CHECK(make_domain(regions_of({{left}, {rectangle(1, 1, 2, 2)}})).has_value());
  CHECK(make_domain(regions_of({{rectangle(-1, -1, 3, 3), left}, {left}})).has_value());
  CHECK(make_domain(regions_of({{left}, {rectangle(5, 0, 6, 1)}})).has_value());
  // Partly shared line, corner on an edge, crossing, inside without a hole, twice the same.
  CHECK(refused(regions_of({{left}, {rectangle(1, 0, 2, 2)}})).code ==
        ErrorCode::overlapping_edges);
  Error error = refused(regions_of({{left}, {{{1, 0.5}, {2, 0}, {2, 1}}}}));
  CHECK(error.code == ErrorCode::touching);
  CHECK(error.message.find("Add this point") != std::string::npos);
  error = refused(regions_of({{left}, {rectangle(0.5, 0.5, 2, 2)}}));
  CHECK(error.code == ErrorCode::region_conflict);
  CHECK(error.where.has_point);
  CHECK(refused(regions_of({{rectangle(-1, -1, 3, 3)}, {left}})).code ==
        ErrorCode::region_conflict);
  CHECK(refused(regions_of({{left}, {left}})).code == ErrorCode::region_conflict);
  // Both regions are named, whether the inner one is apart, at a corner, or comes first.
  const Loop hung{{0, 0}, {0.5, 0.2}, {0.2, 0.5}};
  for (const auto& input : {regions_of({{rectangle(-1, -1, 3, 3)}, {left}}),
                            regions_of({{left}, {rectangle(-1, -1, 3, 3)}}),
                            regions_of({{left}, {hung}}), regions_of({{hung}, {left}})}) {
    const std::string message = refused(input).message;
    INFO(message);
    CHECK(message.find("region 0") != std::string::npos);
    CHECK(message.find("region 1") != std::string::npos);
    CHECK(message.find("outside") == std::string::npos);
  }
  // Within the other region, but hung at its corner.
  CHECK(refused(regions_of({{left}, {{{0, 0}, {0.5, 0.2}, {0.2, 0.5}}}})).code ==
        ErrorCode::region_conflict);
}

TEST_CASE("regions that rounding has parted are told of, others are not") {
  const auto beside = [](double gap) {
    return regions_of({{rectangle(0, 0, 1, 1)}, {rectangle(1 + gap, 0, 2, 1)}});
  };
  for (const double gap : {1e-15, 1e-9, 1e-6}) {
    const auto domain = make_domain(beside(gap));
    REQUIRE(domain.has_value());
    REQUIRE(domain->warnings.size() == 1);
    const Warning& warning = domain->warnings[0];
    CHECK(warning.code == ErrorCode::touching);
    CHECK(warning.where.has_point);
    CHECK(warning.where.x == Approx(1));
    CHECK(warning.message.find("edge 1 of loop 0 of region 0") != std::string::npos);
    CHECK(warning.message.find("edge 3 of loop 0 of region 1") != std::string::npos);
  }
  // A gap that is meant, a common edge, and one with a short edge in it.
  CHECK(make_domain(beside(0.01))->warnings.empty());
  CHECK(make_domain(beside(0))->warnings.empty());
  const Loop right = {{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0.5}, {1, 0.5 - 1e-9}};
  const Loop left = {{0, 0}, {1, 0}, {1, 0.5 - 1e-9}, {1, 0.5}, {1, 1}, {0, 1}};
  CHECK(make_domain(regions_of({{left}, {right}}))->warnings.empty());
}

TEST_CASE("walls that leave no room between them are refused") {
  const auto frame = rectangle(0, 0, 1, 1);
  for (const double gap : {1e-16, 1e-14}) {
    const Error error = refused(one_region({frame, rectangle(0.2, gap, 0.4, 0.2)}));
    CHECK(error.code == ErrorCode::touching);
    CHECK(error.where.y == Approx(0).margin(1e-9));
    auto input = one_region({frame});
    input.points = {{{0.3, gap}, ""}};
    CHECK(refused(input).code == ErrorCode::touching);
    input.points.clear();
    input.polylines = {{{{0.2, gap}, {0.4, gap}}, "wall"}};
    CHECK(refused(input).code == ErrorCode::touching);
    // A slit in the outline has nothing between its sides.
    CHECK(make_domain(
              one_region(
                  {{{0, 0}, {1, 0}, {1, 1}, {0.5 + gap, 1}, {0.5, 0.5}, {0.5 - gap, 1}, {0, 1}}}))
              .has_value());
  }
  CHECK(make_domain(one_region({frame, rectangle(0.2, 1e-9, 0.4, 0.2)})).has_value());
  // As is a short edge between two walls that meet there.
  CHECK(make_domain(one_region({{{0, 0}, {1, 0}, {1, 1e-15}, {0.9, 1}, {0, 1}}})).has_value());
}

TEST_CASE("polylines lie inside and meet only at points") {
  auto input = one_region({rectangle(0, 0, 10, 10)});
  const auto with = [&](std::vector<std::vector<Vec2>> lines) {
    input.polylines.clear();
    for (auto& line : lines) input.polylines.push_back({std::move(line), "wall"});
    return input;
  };
  auto domain = make_domain(with({{{2, 2}, {5, 5}, {8, 2}}, {{5, 5}, {5, 8}}, {{0, 0}, {2, 2}}}));
  REQUIRE(domain.has_value());
  CHECK(domain->points.size() == 8);
  for (const Segment& s : domain->segments) {
    if (s.region != none) continue;
    CHECK(s.left == 0);
    CHECK(s.right == 0);
    CHECK(domain->tags[s.tag] == "wall");
  }
  CHECK(refused(with({{{5, 5}}})).code == ErrorCode::too_few_points);
  CHECK(refused(with({{{2, 2}, {12, 5}}})).code == ErrorCode::self_intersection);
  CHECK(refused(with({{{2, 2}, {8, 8}}, {{2, 8}, {8, 2}}})).code == ErrorCode::self_intersection);
  CHECK(refused(with({{{2, 2}, {10, 5}}})).code == ErrorCode::touching);
  CHECK(refused(with({{{0, 0}, {10, 0}}})).code == ErrorCode::overlapping_edges);
  CHECK(refused(with({{{0, 0}, {-5, -5}}})).code == ErrorCode::hole_outside);
  CHECK(refused(with({{{20, 20}, {25, 25}}})).code == ErrorCode::hole_outside);
}

TEST_CASE("what is said of polylines that touch or overlap is what helps") {
  auto input = one_region({rectangle(0, 0, 10, 10)});
  const auto says = [&](const DomainInput& wrong, const std::string& part) {
    const std::string message = refused(wrong).message;
    INFO(message);
    CHECK(message.find(part) != std::string::npos);
  };
  input.polylines = {{{{2, 5}, {8, 5}}, "a"}, {{{5, 5}, {5, 8}}, "b"}};
  says(input, "Make this point one of that polyline's");
  input.polylines[0].points = {{2, 5}, {5, 5}, {8, 5}};
  CHECK(make_domain(input).has_value());
  input.polylines = {{{{0, 0}, {5, 5}, {8, 5}, {8, 2}, {3, 3}}, "a"}};
  says(input, "Make this point one of that polyline's");
  input.polylines[0].points = {{0, 0}, {3, 3}, {5, 5}, {8, 5}, {8, 2}, {3, 3}};
  CHECK(make_domain(input).has_value());
  input.polylines = {{{{0, 0}, {10, 0}}, "a"}};
  says(input, "out of the polyline");
  input.polylines = {{{{2, 2}, {8, 8}}, "a"}, {{{8, 8}, {2, 2}}, "b"}};
  says(input, "Remove one of them.");
  input.polylines = {{{{2, 5}, {8, 5}}, "a"}};
  input.points = {{{5, 5}, "probe"}};
  says(input, "Make it a point of that polyline instead.");
  input.polylines[0].points = {{2, 5}, {5, 5}, {8, 5}};
  CHECK(make_domain(input).has_value());
  input.points = {{{5, 0}, "probe"}};
  says(input, "Make it a corner of that edge's loop instead.");
  says(regions_of({{rectangle(0, 0, 1, 1)}, {rectangle(1, 0, 2, 2)}}), "the same two end points");
}

TEST_CASE("of two tags of one edge that of the first region is kept, with a word") {
  auto input = regions_of({{rectangle(0, 0, 1, 1)}, {rectangle(1, 0, 2, 1)}});
  const auto tagged = [&](const std::string& one, const std::string& two) {
    input.regions[0].tags = {{"", one, "", ""}};
    input.regions[1].tags = {{"", "", "", two}};
    return make_domain(input);
  };
  const auto domain = tagged("interface", "contact");
  REQUIRE(domain.has_value());
  REQUIRE(domain->warnings.size() == 1);
  const Warning& warning = domain->warnings[0];
  INFO(warning.message);
  CHECK(warning.code == ErrorCode::ignored);
  CHECK(warning.message.find("\"contact\" of edge 3 of loop 0 of region 1") != std::string::npos);
  CHECK(warning.message.find("edge 1 of loop 0 of region 0") != std::string::npos);
  CHECK(warning.message.find("\"interface\" is kept") != std::string::npos);
  CHECK(warning.where.region == 1);
  CHECK(warning.where.edge == 3);
  for (const Segment& s : domain->segments)
    if (s.right != none) CHECK(domain->tags[s.tag] == "interface");
  CHECK(tagged("interface", "interface")->warnings.empty());
  CHECK(tagged("interface", "")->warnings.empty());
  CHECK(tagged("", "contact")->warnings.empty());
  // Limited, as all warnings of one kind.
  Loop top, bottom;
  for (int i = 0; i <= 30; ++i) {
    top.push_back({i * 1.0, 0});
    bottom.push_back({i * 1.0, 0});
  }
  top.push_back({30, 30});
  bottom.push_back({30, -30});
  input = regions_of({{top}, {bottom}});
  input.regions[0].tags = {std::vector<std::string>(32, "a")};
  input.regions[1].tags = {std::vector<std::string>(32, "b")};
  const auto many = make_domain(input);
  REQUIRE(many.has_value());
  REQUIRE(many->warnings.size() == 21);
  CHECK(many->warnings.back().message == "And 10 more of this kind.");
}

TEST_CASE("points lie strictly inside or on a corner") {
  auto input = square_with_holes();
  input.points = {{{5, 5}, "probe"}, {{10, 10}, "corner"}};
  const auto domain = make_domain(input);
  REQUIRE(domain.has_value());
  CHECK(domain->points.size() == 12);
  CHECK(domain->given.back() == Vec2{5, 5});
  CHECK(domain->tags[domain->point_tag.back()] == "probe");
  input.points = {{{5, 5}, ""}, {{5, 5}, ""}};
  CHECK(make_domain(input)->warnings.size() == 1);
  CHECK(refused(input, {.strict = true}).code == ErrorCode::duplicate_point);
  input.points = {{{5, 0}, ""}};
  CHECK(refused(input).code == ErrorCode::touching);
  input.points = {{{3, 3}, ""}};
  CHECK(refused(input).code == ErrorCode::hole_outside);
  input.points = {{{50, 3}, ""}};
  CHECK(refused(input).code == ErrorCode::hole_outside);
}
