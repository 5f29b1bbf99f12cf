#include "core/explain/derivation.h"

#include "core/base/decimal.h"

#include <cmath>

namespace normalscope {

namespace {

struct Parts {
    Expression n_obj, v_obj, n_world, v_world, m3;
    int rank = 3;
    bool affine = true;
};

std::optional<Value> times(const std::optional<Value>& a, const std::optional<Value>& b) {
    return a && b ? product(*a, *b) : std::nullopt;
}

// Empty for what is zero but for rounding: the zero vector is nobody's normal.
std::optional<Value> if_not_zero(const std::optional<Value>& v) {
    if (v)
        for (int r = 0; r < v->rows; ++r)
            if (v->clean(r, 0) != 0.0) return v;
    return std::nullopt;
}

Step step(std::string id, Expression line, std::string reason) {
    Step result{.id = std::move(id), .line = std::move(line), .reason = std::move(reason), .remark = {}};
    const auto &left = result.left().value, &right = result.right().value;
    if (left && right) result.residual = difference(*left, *right);
    if (result.residual) result.state = result.residual->within_rounding ? Step::State::Holds : Step::State::Fails;
    return result;
}

std::vector<Step> derive(const Parts& p) {
    const Expression m3t = transposed(p.m3);
    const Expression m3t_n = multiplied({m3t, p.n_world});
    std::vector<Step> steps;
    const auto add = [&](std::string id, Expression left, Expression right, std::string reason) {
        steps.push_back(step(std::move(id), equals(std::move(left), std::move(right)), std::move(reason)));
    };
    add("given", dot(p.n_obj, p.v_obj), zero(), "what a normal is: it is perpendicular to every tangent v_obj");
    add("wanted", dot(p.n_world, p.v_world), zero(),
        "what we want: a normal in the world is perpendicular to every tangent v_world");
    add("tangent", dot(p.n_world, multiplied({p.m3, p.v_obj})), zero(),
        "a tangent is a vector, so M carries it along; its w is 0, so translation drops out and only M₃ counts");
    add("as-matrices", multiplied({transposed(p.n_world), p.m3, p.v_obj}), zero(),
        "a dot product is a row times a column: a · b = aᵀ b");
    add("transposed-twice", multiplied({transposed(p.n_world), transposed(m3t), p.v_obj}), zero(),
        "transposing twice changes nothing: M₃ = (M₃ᵀ)ᵀ");
    add("product-of-transposes", multiplied({transposed(m3t_n), p.v_obj}), zero(),
        "the transpose of a product is the product of the transposes in reverse order: (AB)ᵀ = Bᵀ Aᵀ");
    add("as-dot-product", dot(m3t_n, p.v_obj), zero(), "and back: a row times a column is a dot product");
    add("same-direction", m3t_n, p.n_obj,
        "this holds for every tangent v_obj, so M₃ᵀ n_world is perpendicular to the surface, as n_obj is; "
        "only the direction counts, so let them be equal");
    add("solved", p.n_world, multiplied({inverted(m3t, p.rank), p.n_obj}),
        "multiply by the inverse of M₃ᵀ from the left");
    add("rule", p.n_world, multiplied({transposed(inverted(p.m3, p.rank)), p.n_obj}),
        "inverting and transposing can be swapped: (Aᵀ)⁻¹ = (A⁻¹)ᵀ");
    return steps;
}

// Where the argument stops under an M that is not affine, and what holds in its place.
void remark_not_affine(Step& wanted, Step& tangent, Step& solved, const Parts& p) {
    if (!p.n_world.value) {
        wanted.remark = "M leaves no surface here, and so no normal";
        return;
    }
    wanted.remark =
        "M is not affine: n_world is the image of the tangent plane π = (n_obj, −n_obj · p), w times the first three "
        "numbers of (M⁻¹)ᵀ π; and v_world comes from the Jacobian, (M₃ − p′ rᵀ)/w v_obj, with p′ the image of the "
        "point p, rᵀ the "
        "first "
        "three numbers of M’s bottom row, and w what p′ was divided by";
    tangent.remark =
        tangent.state == Step::State::Holds
            ? "this tangent’s w stays as it is, but other tangents’ do not, since M is not affine: for them "
              "the argument stops here"
            : "here the argument stops: M is not affine, so that it divides by a w that changes along the "
              "tangent, and M₃ v_obj is not v_world. No 3×3 matrix is right everywhere; what follows is "
              "what M₃ alone would do";
    if (p.rank < 3) solved.remark = "M₃ has no inverse, whether or not M has one";
}

// What can be said of the lines when M3 has no inverse, or there is nothing to say it of.
void remark(std::vector<Step>& steps, const Parts& p, const std::optional<Rule>& by, bool probed) {
    const auto at = [&](std::string_view id) -> Step& {
        for (Step& s : steps)
            if (s.id == id) return s;
        return steps.front();
    };
    if (!probed) {
        at("given").remark = "no numbers here: no part of the surface can be seen, or there is no normal at the probe";
        return;
    }
    if (!p.affine) return remark_not_affine(at("wanted"), at("tangent"), at("solved"), p);
    if (p.rank == 3) return;
    const std::string rank = "M₃ has rank " + std::to_string(p.rank);
    if (by) {
        // Where M3 is large, its rounding of 0 may be larger than n_obj: the rank decides, not the numbers.
        at("same-direction").state = Step::State::Fails;
        at("wanted").remark = rank + ": n_world is the cofactor's here, cof(M₃) n_obj, which exists without an inverse";
        at("same-direction").remark =
            rank +
            ": M₃ᵀ n_world is 0, which is perpendicular to every v_obj, and no n_world makes it n_obj; "
            "here the derivation stops";
    } else {
        at("wanted").remark =
            p.rank == 2   ? rank + ", and the tangent plane is flattened to a line here: it has no single normal"
            : p.rank == 1 ? rank + ": the surface is flattened to a line, which has no single normal"
                          : rank + ": the surface has shrunk to a point, which has no normal";
    }
    at("solved").remark = rank + ": there is no inverse";
}

RuleCheck check(Rule rule, const std::optional<Value>& n, const std::array<std::optional<Value>, 2>& v,
                const std::optional<Value>& truth) {
    const auto vec = [](const Value& value) { return glm::dvec3(value(0, 0), value(1, 0), value(2, 0)); };
    RuleCheck result;
    result.rule = rule;
    result.normal = if_not_zero(n);
    if (!result.normal) return result;
    for (std::size_t k = 0; k < 2; ++k)
        if (v[k]) {
            result.dots[k] = product(transpose(*result.normal), *v[k]);
            if (if_not_zero(v[k])) result.degrees_between[k] = angle_degrees(vec(*result.normal), vec(*v[k]));
        }
    if (truth) {
        result.degrees_off = angle_degrees(vec(*result.normal), vec(*truth));
        // The cofactor's normal may point to the other side, by its own convention: that is not off.
        if (result.degrees_off && rule == Rule::Cofactor && *result.degrees_off > 90.0)
            *result.degrees_off = 180.0 - *result.degrees_off;
    }
    return result;
}

HomogeneousDemo homogeneous(const Transform<World, Object>& m, int factors, const std::optional<Probe>& probe,
                            std::size_t tangent) {
    HomogeneousDemo demo;
    demo.m = value_of(m.matrix(), factors);
    demo.reason =
        "the last column of M, the translation, is multiplied by w: by 1 for a point, by 0 for a vector. A normal is "
        "not a point: sent with w = 1, it would pick up the translation";
    if (!m.affine())
        demo.reason =
            "the bottom row of M is not 0 0 0 1, so M is not affine: it changes a point's w, which is then divided "
            "out, and what it does to a tangent depends on the place. What is said of M₃ does not hold for all of M";
    if (!probe) return demo;
    demo.before = {value_of(glm::dvec4(probe->point.xyz, 1.0)),
                   value_of(glm::dvec4(probe->tangents[tangent].xyz, 0.0))};
    for (std::size_t i = 0; i < 2; ++i) demo.after[i] = product(demo.m, *demo.before[i]);
    demo.normal_as_point = product(demo.m, value_of(glm::dvec4(probe->normal.xyz, 1.0)));
    return demo;
}

}  // namespace

std::string written_out(const Step& step) {
    const Expression& left = step.left();
    if (left.kind != Expression::Kind::Dot || !left.value) return {};
    const auto &a = left.operands[0].value, &b = left.operands[1].value;
    if (!a || !b || a->rows != 3 || b->rows != 3) return {};
    // As the matrices beside it have them.
    const auto size = [](double x) {
        x = std::abs(x);
        return x >= 5e-4 && x < 1000.0 ? with_decimals(x, 3) : number_text(x, 0.0, 3);
    };
    std::string text;
    const auto factor = [&](double x) {
        const std::string minus = "−" + size(x);
        return x >= 0.0 ? size(x) : text.empty() ? minus : "(" + minus + ")";
    };
    for (int r = 0; r < 3; ++r) {
        const double x = a->clean(r, 0), y = b->clean(r, 0);
        if (x * y < 0.0) {
            text += (r == 0 ? "−" : " − ") + size(x) + "·" + size(y);
            continue;
        }
        if (r > 0) text += " + ";
        text += factor(x);
        text += "·" + factor(y);
    }
    return text + " = " + (step.state == Step::State::Holds ? "0" : number_text(*left.value, 0, 0, 3));
}

std::string_view name(Step::State state) {
    constexpr std::array<std::string_view, 3> kNames{"holds", "fails", "no-value"};
    return kNames.at(static_cast<std::size_t>(state));
}

Derivation derivation(const Transform<World, Object>& world_from_object, int factors, const std::optional<Probe>& probe,
                      std::size_t tangent) {
    const NormalMatrices& matrices = world_from_object.normal_matrices_by_rule();
    const Value m3 = value_of(matrices.naive, factors);
    std::optional<Value> n_obj;
    std::array<std::optional<Value>, 2> v_obj, v_world;
    const bool affine = world_from_object.affine();
    // What takes tangents along at the probe.
    const Transform<World, Object> local = probe ? world_from_object.at(probe->point) : world_from_object;
    const int local_rank = local.normal_matrices_by_rule().rank;
    const Value jacobian = affine ? m3 : value_of(local.normal_matrices_by_rule().naive, factors + 2);
    if (probe) {
        n_obj = value_of(probe->normal.xyz);
        for (std::size_t k = 0; k < 2; ++k) {
            v_obj[k] = value_of(probe->tangents[k].xyz);
            v_world[k] = times(jacobian, v_obj[k]);
        }
    }
    const std::optional<Value> inverted_m3 = inverse(m3, matrices.rank);
    const std::array<std::optional<Value>, 3> normals{
        times(m3, n_obj), times(inverted_m3 ? std::optional(transpose(*inverted_m3)) : std::nullopt, n_obj),
        times(cofactor(m3, matrices.rank), n_obj)};

    Derivation result;
    result.affine = affine;
    const std::optional<Value> back = inverse(jacobian, local_rank);
    const std::optional<Value> truth = affine && matrices.rank == 3 ? normals[1]
                                       : back                       ? times(transpose(*back), n_obj)
                                              : if_not_zero(times(cofactor(jacobian, local_rank), n_obj));
    if (truth && affine) result.n_world_by = matrices.rank == 3 ? Rule::InverseTranspose : Rule::Cofactor;
    result.n_world = truth;
    const Meaning by = !affine                               ? Meaning::Plain
                       : result.n_world_by == Rule::Cofactor ? Meaning::Cofactor
                                                             : Meaning::InverseTranspose;
    const Parts parts{.n_obj = symbol(Symbol::NObject, Meaning::Object, n_obj),
                      .v_obj = symbol(Symbol::VObject, Meaning::Tangent, v_obj[tangent]),
                      .n_world = symbol(Symbol::NWorld, by, truth),
                      .v_world = symbol(Symbol::VWorld, Meaning::Tangent, v_world[tangent]),
                      .m3 = symbol(Symbol::M3, Meaning::Plain, m3),
                      .rank = matrices.rank,
                      .affine = affine};
    result.steps = derive(parts);
    remark(result.steps, parts, result.n_world_by, probe.has_value());
    for (std::size_t r = 0; r < kRules.size(); ++r) result.checks[r] = check(kRules[r], normals[r], v_world, truth);
    result.homogeneous = homogeneous(world_from_object, factors, probe, tangent);
    return result;
}

}  // namespace normalscope
