#include "patch/minimum.h"

enum { STEPS = 60 };

double kg_minimum(double (*f)(void *user, double x), void *user, double lo, double hi,
                  double narrow, double *out_x) {
    const double golden = 0.38196601125010515;
    double x = lo + golden * (hi - lo), w = x, v = x; /* best, second, the second before */
    double fx = f(user, x), fw = fx, fv = fx, step = 0, before = 0;
    for (int i = 0; i < STEPS; i++) {
        double middle = 0.5 * (lo + hi);
        if (fabs(x - middle) <= 2 * narrow - 0.5 * (hi - lo))
            break;
        double a = (x - w) * (fx - fv), b = (x - v) * (fx - fw);
        double above = (x - v) * b - (x - w) * a, below = 2 * (b - a);
        double parabola = -above / below;
        bool good = fabs(parabola) < 0.5 * fabs(before) && x + parabola > lo && x + parabola < hi;
        before = good ? step : (x < middle ? hi : lo) - x;
        step = good ? parabola : golden * before;
        if (fabs(step) < narrow)
            step = x < middle ? narrow : -narrow;
        double u = x + step, fu = f(user, u);
        if (fu <= fx) {
            *(u < x ? &hi : &lo) = x;
            v = w, fv = fw, w = x, fw = fx, x = u, fx = fu;
        } else {
            *(u < x ? &lo : &hi) = u;
            if (fu <= fw || w == x)
                v = w, fv = fw, w = u, fw = fu;
            else if (fu <= fv || v == x || v == w)
                v = u, fv = fu;
        }
    }
    *out_x = x;
    return fx;
}
