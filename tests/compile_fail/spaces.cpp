// The types forbid what the theory forbids. Each block is compiled alone and must be refused.

#include "core/math/transform.h"

using namespace normalscope;

struct View {};

const Transform<World, Object> world_from_object;
const Transform<View, World> view_from_world;
const Point<Object> p, q;
const Vector<Object> t;
const Normal<Object> n;
const Point<World> worldPoint;
const Normal<World> worldNormal;

// What is allowed.
const Vector<Object> difference = p - q;
const Point<Object> moved = p + t;
const Point<World> image = world_from_object(p);
const Vector<World> tangentImage = world_from_object(t);
const std::optional<Normal<World>> normalImage = world_from_object(n);
const Normal<World> naiveImage = transform_normal_naively(world_from_object, n);
const double product = dot(n, t);
const Transform<View, Object> view_from_object = view_from_world * world_from_object;

#ifdef EXPECT_ERROR_points_do_not_add
const auto sum = p + q;
#endif

#ifdef EXPECT_ERROR_points_of_two_spaces_have_no_difference
const auto gap = worldPoint - p;
#endif

#ifdef EXPECT_ERROR_a_normal_does_not_go_through_M
const Vector<World> image_by_m = world_from_object(n);
#endif

#ifdef EXPECT_ERROR_a_normals_image_may_not_exist
const Normal<World> always = world_from_object(n);
#endif

#ifdef EXPECT_ERROR_a_normal_is_no_vector
const Vector<Object> v = n;
#endif

#ifdef EXPECT_ERROR_a_vector_is_no_normal
const Normal<Object> m = t;
#endif

#ifdef EXPECT_ERROR_a_world_point_is_not_transformed_from_object
const auto twice = world_from_object(worldPoint);
#endif

#ifdef EXPECT_ERROR_a_world_normal_is_not_transformed_naively_from_object
const auto wrong = transform_normal_naively(world_from_object, worldNormal);
#endif

#ifdef EXPECT_ERROR_transforms_compose_only_where_spaces_meet
const auto composite = world_from_object * view_from_world;
#endif

#ifdef EXPECT_ERROR_a_normal_is_not_dotted_with_another_spaces_vector
const double d = dot(worldNormal, t);
#endif

#ifdef EXPECT_ERROR_a_normal_does_not_displace_a_point
const auto displaced = p + n;
#endif
