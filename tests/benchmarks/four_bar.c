/* A four-bar by hand in C, as one writes it who knows the compiler: a loop that it can take eight positions at once,
   with its own sine and cosine. Every position is proved as by `planes`: lengths, closed polygons, finite numbers. */
#include <math.h>
#include <stdint.h>

static inline void sincos_deg(double phi, double *s, double *c) {
    double q = rint(phi / 90.0), x = (phi - 90.0 * q) * 0.017453292519943295, z = x * x;
    double sn = x + x * z * (-1.66666666666666324348e-01 + z * (8.33333333332248946124e-03 + z * (-1.98412698298579493134e-04
              + z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)))));
    double cn = 1.0 - 0.5 * z + z * z * (4.16666666666666019037e-02 + z * (-1.38888888888741095749e-03 + z * (2.48015872894767294178e-05
              + z * (-2.75573143513906633035e-07 + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
    double turn = q - 4.0 * floor(q / 4.0), odd = turn == 1.0 || turn == 3.0;
    double one = odd ? cn : sn, two = odd ? sn : cn;
    *s = turn >= 2.0 ? -one : one;
    *c = turn == 1.0 || turn == 2.0 ? -two : two;
}

int64_t four_bar(const double *restrict phis, double *restrict out, int64_t *restrict codes, int64_t n, int64_t stride,
                 const double *restrict given) {
    const double r = given[0], l2 = given[1], l3 = given[2], dx = given[3], dy = given[4], side = given[5];
    const double omega = given[6], epsilon = given[7], small = 1e-24;
    int64_t failed = 0;
#pragma omp simd reduction(| : failed)
    for (int64_t i = 0; i < n; i++) {
        double s, c;
        sincos_deg(phis[i], &s, &c);
        double bx = r * c, by = r * s, ex = dx - bx, ey = dy - by, apart2 = ex * ex + ey * ey, inv = 1.0 / apart2;
        double along = 0.5 + 0.5 * (l2 * l2 - l3 * l3) * inv, under = l2 * l2 * inv - along * along;
        double high = side * sqrt(under > 0.0 ? under : 0.0);
        double px = ex * along - ey * high, py = ey * along + ex * high, qx = px - ex, qy = py - ey;
        double vx = -omega * by, vy = omega * bx;
        double ax = -epsilon * by - omega * omega * bx, ay = epsilon * bx - omega * omega * by;
        double over = 1.0 / (px * qy - py * qx);
        double w2 = -(vx * qx + vy * qy) * over, w3 = -(vx * px + vy * py) * over;
        double sx = ax - w2 * w2 * px + w3 * w3 * qx, sy = ay - w2 * w2 * py + w3 * w3 * qy;
        double e2 = -(sx * qx + sy * qy) * over, e3 = -(sx * px + sy * py) * over;
        double cvx = -w3 * qy, cvy = w3 * qx, cax = -e3 * qy - w3 * w3 * qx, cay = e3 * qx - w3 * w3 * qy;
        double g2 = px * px + py * py - l2 * l2, g3 = qx * qx + qy * qy - l3 * l3;
        double ux = vx - w2 * py - cvx, uy = vy + w2 * px - cvy;
        double tx = ax - e2 * py - w2 * w2 * px - cax, ty = ay + e2 * px - w2 * w2 * py - cay;
        double vsize = vx * vx + vy * vy + cvx * cvx + cvy * cvy, asize = ax * ax + ay * ay + cax * cax + cay * cay;
        double gap = g2 * g2 + g3 * g3, vgap = ux * ux + uy * uy, agap = tx * tx + ty * ty;
        int64_t bad = !(under >= 0.0) ? 1 : !(gap <= small * apart2 * apart2) ? 2 : !(vgap <= small * vsize) ? 3
                    : !(agap <= small * asize) ? 4 : !(fabs(gap + vgap + agap) < INFINITY) ? 5 : 0;
        out[i] = bx, out[stride + i] = by, out[2 * stride + i] = vx, out[3 * stride + i] = vy;
        out[4 * stride + i] = ax, out[5 * stride + i] = ay, out[6 * stride + i] = bx + px, out[7 * stride + i] = by + py;
        out[8 * stride + i] = cvx, out[9 * stride + i] = cvy, out[10 * stride + i] = cax, out[11 * stride + i] = cay;
        out[12 * stride + i] = w2, out[13 * stride + i] = w3, out[14 * stride + i] = e2, out[15 * stride + i] = e3;
        codes[i] = bad;
        failed |= bad;
    }
    return failed;
}
