// What formulas are made of, in floats, or in doubles where DOUBLES is defined.
#ifdef DOUBLES

#define REAL double
#define REAL2 dvec2
#define REAL3 dvec3
#define DOUBLE true
// How near to 0 and how large a number may be.
#define TINY 1e-290lf
#define ROOT_OF_TINY 1e-145lf
#define LEAST 2.3e-308lf
#define HUGE 1e290lf
#define LARGEST 1e300lf
#define MOST_EXPONENT 660.0lf

// What GLSL has for floats only, in doubles. Arguments are reduced to where a short series is exact to the last digits or
// so. (Muller, "Elementary Functions: Algorithms and Implementation", chapters 3 and 11.)
double exp(double x) {
    if (x < -740.0lf) return 0.0lf;
    double k = floor(min(x, 700.0lf) * 1.4426950408889634lf + 0.5lf);
    double r = (min(x, 700.0lf) - k * 0.693147180369123816490lf) - k * 1.90821492927058770002e-10lf;  // ln 2 in two parts
    double sum = 1.0lf;
    for (int i = 13; i > 0; --i) sum = 1.0lf + sum * r / double(i);
    return ldexp(sum, int(k));
}

double log(double x) {
    int e;
    double m = frexp(x, e);
    if (m < 0.70710678118654752lf) {
        m *= 2.0lf;
        --e;
    }
    double s = (m - 1.0lf) / (m + 1.0lf), square = s * s, sum = 0.0lf;
    for (int i = 21; i > 0; i -= 2) sum = sum * square + 1.0lf / double(i);
    return double(e) * 0.69314718055994531lf + 2.0lf * s * sum;
}

double pow(double b, double e) { return exp(e * log(b)); }

// sin(x + quarters π/2).
double wave(double x, int quarters) {
    double k = floor(x * 0.63661977236758134lf + 0.5lf);
    double r = (x - k * 1.57079632673412561417lf) - k * 6.07710050650619224932e-11lf;  // π/2 in two parts
    int turn = (int(mod(k, 4.0lf)) + quarters) & 3;
    double square = r * r, sum = 1.0lf;
    bool odd = (turn & 1) == 0;
    for (int i = 18; i > 0; i -= 2) sum = 1.0lf - sum * square / double(i * (i + (odd ? 1 : -1)));
    sum *= odd ? r : 1.0lf;
    return turn < 2 ? sum : -sum;
}
double sin(double x) { return wave(x, 0); }
double cos(double x) { return wave(x, 1); }
double tan(double x) { return wave(x, 0) / wave(x, 1); }

double atan(double x) {
    double size = abs(x), s = size > 1.0lf ? 1.0lf / size : size;
    for (int i = 0; i < 2; ++i) s = s / (1.0lf + sqrt(1.0lf + s * s));
    double square = s * s, sum = 0.0lf;
    for (int i = 23; i > 0; i -= 2) sum = 1.0lf / double(i) - sum * square;
    double angle = 4.0lf * s * sum;
    if (size > 1.0lf) angle = 1.57079632679489662lf - angle;
    return x < 0.0lf ? -angle : angle;
}
double atan(double y, double x) {
    if (abs(x) >= abs(y)) return atan(y / x) + (x > 0.0lf ? 0.0lf : y < 0.0lf ? -3.14159265358979324lf : 3.14159265358979324lf);
    return (y < 0.0lf ? -1.57079632679489662lf : 1.57079632679489662lf) - atan(x / y);
}

#define wave_sin sin
#define wave_cos cos

#else

#define REAL float
#define REAL2 vec2
#define REAL3 vec3
#define DOUBLE false
#define TINY 1e-30
#define ROOT_OF_TINY 1e-15
#define LEAST 1.2e-38
#define HUGE 1e30
#define LARGEST 3e37
#define MOST_EXPONENT 69.0

// sin(x − kπ) for k near x/π: to 24 bits or nearly so, as drivers' own sines are, in half the steps, since all rays of a
// picture spend their time here. π is in two parts. The polynomial has the least largest error on [−π/2, π/2].
float half_turns(float x, float k) {
    float r = (x - k * 3.140625) - k * 9.67653589793e-4, q = r * r;
    return r + r * q * (-0.166666597 + q * (0.00833306648 + q * (-1.98095950e-4 + q * 2.60576166e-6)));
}
float wave_sin(float x) {
    float k = floor(x * 0.318309886 + 0.5), s = half_turns(x, k);
    return fract(0.5 * k) > 0.25 ? -s : s;
}
float wave_cos(float x) {
    float k = floor(x * 0.318309886) + 0.5, s = half_turns(x, k);
    return fract(0.5 * k) < 0.5 ? -s : s;
}

#endif

// What GLSL has not, or leaves undefined outside a domain: there these give something finite, and is_defined says no.

REAL nonzero(REAL v) { return abs(v) > TINY ? v : v < 0.0 ? -TINY : TINY; }
REAL safe_pow(REAL b, REAL e) { return min(pow(max(b, TINY), e), HUGE); }
REAL odd_pow(REAL b, REAL e) { return sign(b) * min(pow(max(abs(b), TINY), e), HUGE); }
REAL any_pow(REAL b, REAL e) {
    REAL s = min(pow(max(abs(b), TINY), e), HUGE);
    return b < 0.0 && mod(e, 2.0) == 1.0 ? -s : s;
}
REAL angle_of(REAL y, REAL x) { return x == 0.0 && y == 0.0 ? REAL(0.0) : atan(y, x); }
// √(1 − v²): drivers' own arcsines are right to four digits only.
REAL leg(REAL v) { return sqrt(max((1.0 - v) * (1.0 + v), 0.0)); }
REAL safe_exp(REAL v) { return max(exp(min(v, MOST_EXPONENT)), LEAST); }
REAL sinh_of(REAL v) { return 0.5 * (safe_exp(v) - safe_exp(-v)); }
REAL cosh_of(REAL v) { return 0.5 * (safe_exp(v) + safe_exp(-v)); }
REAL tanh_of(REAL v) {
    REAL e = safe_exp(-2.0 * abs(v));
    return sign(v) * (1.0 - e) / (1.0 + e);
}
REAL sech_of(REAL v) {
    REAL e = safe_exp(-abs(v));
    return 2.0 * e / (1.0 + e * e);
}
// arsinh and arcosh, and their slope. Beyond 10⁸ the 1 is lost in the square, which may be too large for a number.
REAL area_of(REAL v, REAL one) { return v > 1e8 ? log(v) + log(REAL(2.0)) : log(v + sqrt(v * v + one)); }
REAL area_slope(REAL v, REAL one) { return v > 1e8 ? 1.0 / v : 1.0 / sqrt(max(v * v + one, TINY)); }
