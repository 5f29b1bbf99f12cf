// Where the ray through each pixel first meets f = 0. formula.glsl is made for the formula at hand: f, gradient and is_defined,
// and the interpolation of f between DEGREE + 1 samples.
//
// A part of the ray is free of roots if all Bernstein coefficients of f there have one sign, has just one if they change
// it once, and is halved otherwise. Polynomials of that degree are met exactly; for anything else the interpolant's
// last terms tell how far it may be off, and what is not safe is halved.
#include "functions.glsl"
#include "formula.glsl"
#include "edges.glsl"

in vec3 ray;

uniform vec3 eye;
uniform vec3 box_low, box_high;  // beyond it there is no root
uniform float ball;              // radius of the ball that cuts the surface off; 0: none does
uniform sampler2D centres;       // what this wrote for the pixels' centres
uniform float only_edges;        // 1: only where those show that a pixel holds more than one thing

out vec4 hit;  // unit n_object, or 0 where there is none; t, or 0 for a miss, or −1 for a pixel left out

const int ATTEMPTS = POLYNOMIAL ? 1 : 12;
const int STEPS = (POLYNOMIAL ? 48 : 384) * (DOUBLE ? 2 : 1);
// Of the whole: parts so narrow that f is zero there as far as can be told, how closely a root is told, and how near to it the
// regula falsi converges fast.
const REAL NARROWEST = DOUBLE ? 1.0 / 65536.0 : 1.0 / 4096.0;
const REAL CLOSE = DOUBLE ? 1e-12 : 2e-7, NEAR = DOUBLE ? 4e-6 : 2e-3;

void main() {
    hit = vec4(0.0, 0.0, 0.0, -1.0);
    if (only_edges > 0.5) {
        ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(centres, 0) - 1;
        vec4 here = texelFetch(centres, at, 0);
        bool edge = false;
        for (int i = 0; i < 4; ++i) {
            ivec2 beside = at + ivec2(i == 0 ? 1 : i == 1 ? -1 : 0, i == 2 ? 1 : i == 3 ? -1 : 0);
            edge = edge || differ(here, texelFetch(centres, clamp(beside, ivec2(0), last), 0));
        }
        if (!edge) return;
    }
    hit.w = 0.0;

    // Along the ray from its point nearest to the middle, where floats are finest.
    REAL3 d = REAL3(ray);
    REAL3 from_eye = REAL3(eye);
    REAL to_nearest = -dot(from_eye, d) / dot(d, d);
    REAL3 o = from_eye + to_nearest * d;
    REAL3 safe = mix(d, REAL3(1e-20), lessThan(abs(d), REAL3(1e-20)));
    REAL3 a = (REAL3(box_low) - o) / safe, b = (REAL3(box_high) - o) / safe;
    REAL3 entry = min(a, b), leave = max(a, b);
    REAL from = max(max(entry.x, entry.y), max(entry.z, -to_nearest)), to = min(leave.x, min(leave.y, leave.z));
    if (ball > 0.0) {
        REAL reach = sqrt(max(ball * ball - dot(o, o), 0.0) / dot(d, d));
        from = max(from, -reach);
        to = min(to, reach);
    }
    if (from >= to) return;

    REAL narrowest = NARROWEST * (to - from);
    REAL low = from, width = POLYNOMIAL ? to - from : 0.25 * (to - from);
    REAL f_low = f(o + low * d), f_most = 0.0;
    // Of the narrow parts up to here in a row, where |f| is least, what the samples beside that are, and the largest |f|
    // before it and of all: as (t, f) where a place is meant.
    REAL2 dip = REAL2(0.0), dip_left = REAL2(0.0), dip_right = REAL2(0.0), previous = REAL2(0.0);
    REAL peak = 0.0, highest = 0.0;
    bool fresh = true;                 // none in this row yet
    REAL2 before_low = REAL2(0.0, 0.0);  // the last sample before `low`
    for (int attempt = 0; attempt < ATTEMPTS; ++attempt) {
        // The first part with a root: f differs in sign at its ends, or comes near zero at `dip` and goes away again.
        bool found = false, crosses = false;
        REAL left = 0.0, right = 0.0, f_left = 0.0, f_right = 0.0, f_small = 0.0, f_end = 0.0;
        for (int i = 0; i < STEPS; ++i) {
            REAL s[DEGREE + 1], c[DEGREE + 1];
            s[0] = f_low;
            REAL largest = abs(f_low), smallest = abs(f_low), second = LARGEST;
            bool narrow = width < 1.5 * narrowest, dips = false;
            if (narrow && fresh) {
                dip = previous = REAL2(low, f_low);
                if (!POLYNOMIAL) dip_left = before_low;
                peak = abs(before_low.y);
                highest = max(peak, abs(f_low));
            }
            for (int j = 1; j <= DEGREE; ++j) {
                REAL2 here = REAL2(low + width * POINTS[j], 0.0);
                here.y = s[j] = f(o + here.x * d);
                REAL size = abs(here.y);
                largest = max(largest, size);
                second = min(second, max(smallest, size));
                smallest = min(smallest, size);
                if (!narrow) continue;
                bool lower = size < abs(dip.y);
                // All that is not needed for polynomials is marked as such: llvmpipe runs what no pixel wants as well.
                if (!POLYNOMIAL) {
                    if (lower) {
                        dip_left = previous;
                        peak = highest;
                    } else if (!dips && peak > abs(dip.y)) {
                        dip_right = here;
                        dips = true;
                    }
                    previous = here;
                    highest = max(highest, size);
                }
                if (lower) dip = here;
            }
            to_bernstein(s, c);
            REAL least = c[0], most = c[0], changes = 0.0;
            for (int j = 1; j <= DEGREE; ++j) {
                least = min(least, c[j]);
                most = max(most, c[j]);
                changes += c[j] < 0.0 != c[j - 1] < 0.0 ? 1.0 : 0.0;
            }
            REAL slack = ROUNDING * largest;
            f_most = max(f_most, largest);
            bool faithful = true;
            if (!POLYNOMIAL) {
                REAL last = last_terms(s);
                slack += CAUTION * last;
                faithful = last < 0.02 * (most - least) && largest < LARGEST;
            }
            bool free = least > slack || most < -slack;
            crosses = false;
            for (int j = 1; j <= DEGREE; ++j) crosses = crosses || s[j] < 0.0 != f_low < 0.0;
            // What looks free after narrow parts may go on from a kink at their end.
            if (!POLYNOMIAL && free && !narrow && !fresh && smallest >= abs(dip.y) && peak > abs(dip.y)) {
                dip_right = REAL2(low + width * POINTS[1], s[1]);
                dips = true;
            } else {
                dips = dips && (!free || !fresh);
            }
            found = (!free && ((crosses && changes == 1.0 && faithful) || (narrow && (POLYNOMIAL || crosses)))) ||
                    (!POLYNOMIAL && dips);
            if (found) {
                left = crosses ? low : dip.x;
                f_left = f_low;
                right = low + width;
                f_right = s[DEGREE];
                f_small = max(2.0 * smallest, 0.02 * second);
                f_end = min(abs(f_low), abs(s[DEGREE]));
                // Between the first two samples of unlike signs.
                for (int j = DEGREE - 1; crosses && j > 0; --j) {
                    REAL here = low + width * POINTS[j];
                    bool beyond = s[j] < 0.0 != f_low < 0.0;
                    if (beyond) {
                        right = here;
                        f_right = s[j];
                        left = low;
                        f_left = f_low;
                    } else if (left == low) {
                        left = here;
                        f_left = s[j];
                    }
                }
                break;
            }
            if (free || narrow) {
                fresh = !narrow;
                if (!POLYNOMIAL) before_low = REAL2(low + width * POINTS[DEGREE - 1], s[DEGREE - 1]);
                low += width;
                f_low = s[DEGREE];
                if (low >= to - 0.5 * narrowest) break;
                width = min(2.0 * width, to - low);
            } else {
                width *= 0.5;
            }
        }
        if (!found) return;

        // The root between the ends by the regula falsi, in the form that lessens the value at an end which stays (Anderson and
        // Björck, BIT 13, 1973); where three steps leave more than half of the part, as near a multiple root or a pole, one
        // halves it.
        low = right;
        f_low = f_right;
        REAL t = left, f_t = 0.0, side = f_left < 0.0 ? -1.0 : 1.0;
        int long_steps = 0;
        bool descend = !POLYNOMIAL && !crosses;
        REAL shallow = 0.0;
        if (descend) {
            left = dip_left.x;
            f_left = dip_left.y;
            right = dip_right.x;
            shallow = min(abs(f_left), abs(dip_right.y));
        }
        REAL whole = to - from, next = 0.0, expected = 0.0;
        bool arrives = false;  // `next` is hardly farther from the root than can be told
        for (int i = 0; i < 64 && (crosses || (!POLYNOMIAL && descend && i < 24)); ++i) {
            REAL before = right - left;
            t = (left * f_right - right * f_left) / (f_right - f_left);
            if (long_steps > 2) t = left + 0.5 * before;
            if (arrives) t = next;
            bool on_the_left = dip.x - left > right - dip.x;
            if (!POLYNOMIAL && descend) t = 0.5 * (dip.x + (on_the_left ? left : right));
            f_t = f(o + t * d);
            if (!POLYNOMIAL && descend) {
                // Down to where |f| is least, unless f changes its sign on the way: then there is a root before that.
                bool lower = abs(f_t) < abs(dip.y);
                if (f_t < 0.0 != side < 0.0) {
                    if (!on_the_left) {
                        left = dip.x;
                        f_left = dip.y;
                    }
                    right = t;
                    f_right = f_t;
                    descend = false;
                    crosses = true;
                } else if (on_the_left == lower) {
                    right = lower ? dip.x : t;
                } else {
                    left = lower ? dip.x : t;
                    f_left = lower ? dip.y : f_t;
                }
                if (lower) dip = REAL2(t, f_t);
                continue;
            }
            REAL step = abs(t - right);
            bool passes = f_t < 0.0 != f_right < 0.0, comes_near = passes || abs(f_t) <= abs(f_right);
            bool done = f_t == 0.0 || (arrives && abs(f_t) < expected) || (comes_near && step < CLOSE * whole);
            next = t - f_t * (t - right) / (f_t - f_right);
            expected = 0.1 * min(abs(f_t), abs(f_right));
            arrives = step < NEAR * whole && abs(next - t) < 200.0 * CLOSE * whole && comes_near;
            if (passes) {
                left = right;
                f_left = f_right;
            } else {
                f_left *= abs(f_t) < abs(f_right) ? 1.0 - f_t / f_right : 0.5;
            }
            right = t;
            f_right = f_t;
            if (done) break;
            long_steps = long_steps > 2 || abs(right - left) < 0.5 * abs(before) ? 0 : long_steps + 1;
        }
        if (!POLYNOMIAL && descend) {
            t = dip.x;
            f_t = abs(dip.y) < 0.05 * shallow ? 0.0 : LARGEST;
        }
        REAL3 p = o + t * d;
        REAL3 n = gradient(p);
        // At a pole f changes its sign as well, but grows towards it; at a jump it stays farther from 0 than its slope
        // explains; and where it has no value there is no surface.
        REAL explained = 100.0 * CLOSE * whole * abs(dot(n, d)) + 4.0 * ROUNDING * f_end;
        if (!POLYNOMIAL && (!(abs(f_t) <= max(f_small, 1e-4 * f_end)) || abs(f_t) > explained || !is_defined(p))) {
            width = min(narrowest, to - low);
            fresh = true;
            before_low = REAL2(0.0);
            if (low >= to - 0.5 * narrowest) return;
            continue;
        }
        // Where f only touches zero, as a square does, its gradient may be but rounding: a point nearer to the eye has one.
        if ((!crosses && length(n) * length(d) * narrowest < 4.0 * ROUNDING * f_most) || n == REAL3(0.0))
            n = gradient(p - 4.0 * narrowest * d);
        // At a kink, as |g| has, rounding says which side's gradient it is.
        if (!crosses && side * dot(n, d) > 0.0) n = -n;
        // Divided first by the largest: squares of floats overflow soon.
        REAL size = max(abs(n.x), max(abs(n.y), abs(n.z)));
        n = size > TINY ? normalize(n / size) : REAL3(0.0);
        // Seen from where f > 0 it faces the eye; where it is seen edge-on, rounding must not turn it over.
        n -= max(side * dot(n, d), 0.0) * side / dot(d, d) * d;
        hit = vec4(vec3(n), float(to_nearest + t));
        return;
    }
}
