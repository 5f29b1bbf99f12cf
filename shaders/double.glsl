// What GLSL has for floats only, in doubles. Arguments are reduced to where a short series is exact to the last digits or
// so. (Muller, "Elementary Functions: Algorithms and Implementation", chapters 3 and 11.)
#ifdef DOUBLES

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

#endif
