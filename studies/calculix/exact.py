#!/usr/bin/env python3
"""Reference values of the decks of this study, to ten digits.

usage: studies/calculix/exact.py

The blocks have a closed form. The rings depend on the radius alone: equilibrium with the creep strain is solved by quadrature on
Chebyshev points, and Norton's law is integrated by the Runge-Kutta method of Dormand and Prince with a tolerance of 1e-12.
"""

import math

ABSOLUTE = 1e-15  # error of the creep strain allowed in one step


class Ring:
    """Plane strain, inner radius a, outer radius b, free of traction at b; creep strain (r, theta, z) at points."""

    def __init__(self, a, b, young, poisson, creep_factor, exponent, points=28):
        self.young, self.poisson, self.factor, self.exponent = young, poisson, creep_factor, exponent
        self.mu = young/(2*(1 + poisson))
        self.lam = young*poisson/((1 + poisson)*(1 - 2*poisson))
        self.x = [math.cos(math.pi*(points - j)/points) for j in range(points + 1)]
        self.r = [(a + b)/2 + (b - a)/2*x for x in self.x]
        self.integral = self._integration_matrix(points, (b - a)/2)

    def _integration_matrix(self, n, scale):
        """Row i: weights of the integral from a to the i-th point."""
        def integrated(k, x):  # of T_k from -1 to x
            def primitive(y):
                angle = math.acos(max(-1.0, min(1.0, y)))
                if k == 0:
                    return y
                if k == 1:
                    return y*y/2
                return (math.cos((k + 1)*angle)/(k + 1) - math.cos((k - 1)*angle)/(k - 1))/2
            return primitive(x) - primitive(-1.0)
        def coefficient(k, j):  # of T_k in the interpolant of the j-th unit vector
            weight = 2/n*(0.5 if j in (0, n) else 1)*(0.5 if k in (0, n) else 1)
            return weight*math.cos(k*math.pi*(n - j)/n)
        primitives = [[scale*integrated(k, x) for k in range(n + 1)] for x in self.x]
        return [[sum(row[k]*coefficient(k, j) for k in range(n + 1)) for j in range(n + 1)] for row in primitives]

    def _integrate(self, values):
        return [sum(w*v for w, v in zip(row, values)) for row in self.integral]

    def solve(self, creep, inner):
        """Displacement and stress. `inner(alpha, beta)`: s_r(a) and u(a) are related by s_r(a) = alpha + beta u(a)."""
        m, mu, a, b = self.lam + 2*self.mu, self.mu, self.r[0], self.r[-1]
        h = self._integrate([(e[0] - e[1])/r for e, r in zip(creep, self.r)])
        g = [e[0] + value for e, value in zip(creep, h)]
        w = [2*mu/m*value/r for value, r in zip(self._integrate([value*r for value, r in zip(g, self.r)]), self.r)]
        # u = c1 (r^2 - a^2)/(2 r) + c2/r + w,  s_r = m c1 + 2 mu (h - u/r)
        alpha, beta = inner
        # s_r(b) = 0 and s_r(a) = alpha + beta u(a), with u(a) = c2/a
        k11, k12, f1 = m - mu*(b*b - a*a)/b**2, -2*mu/b**2, -2*mu*(h[-1] - w[-1]/b)
        k21, k22, f2 = m, -2*mu/a**2 - beta/a, alpha
        determinant = k11*k22 - k12*k21
        c1, c2 = (f1*k22 - k12*f2)/determinant, (k11*f2 - k21*f1)/determinant
        u = [c1*(r*r - a*a)/(2*r) + c2/r + value for r, value in zip(self.r, w)]
        stress = []
        for r, ui, gi, hi, e in zip(self.r, u, g, h, creep):
            trace = 2*mu/m*gi + c1
            s_r = m*c1 + 2*mu*(hi - ui/r)
            s_t = self.lam*trace + 2*mu*(ui/r - e[1])
            stress.append((s_r, s_t, self.lam*trace - 2*mu*e[2]))
        return u, stress

    def rate(self, creep, inner):
        rates = []
        for s in self.solve(creep, inner)[1]:
            mean = sum(s)/3
            q = math.sqrt(1.5*sum((x - mean)**2 for x in s))
            rates.append([1.5*self.factor*q**(self.exponent - 1)*(x - mean) for x in s])
        return rates

    def run(self, end, inner):
        """Displacement and stress at the end."""
        table = ((1/5,), (3/40, 9/40), (44/45, -56/15, 32/9), (19372/6561, -25360/2187, 64448/6561, -212/729),
                 (9017/3168, -355/33, 46732/5247, 49/176, -5103/18656), (35/384, 0, 500/1113, 125/192, -2187/6784, 11/84))
        error = (71/57600, 0, -71/16695, 71/1920, -17253/339200, 22/525, -1/40)
        creep, time, step = [[0.0]*3 for _ in self.r], 0.0, end*1e-8
        first = self.rate(creep, inner)
        while time < end:
            step = min(step, end - time)
            stages = [first]
            for row in table:
                trial = [[c + step*sum(a*k[i][j] for a, k in zip(row, stages)) for j, c in enumerate(e)]
                         for i, e in enumerate(creep)]
                stages.append(self.rate(trial, inner))
            size = max(abs(step*sum(d*k[i][j] for d, k in zip(error, stages))) for i in range(len(creep)) for j in range(3))
            if size <= TOLERANCE:
                creep, time, first = trial, time + step, stages[-1]
                if end - time < 1e-12*end:
                    break
            step *= min(5, max(0.2, 0.9*(TOLERANCE/max(size, 1e-30))**0.2))
        return self.solve(creep, inner)


TOLERANCE = 1e-13  # of the creep strain in one step


def shrink_fit():
    """Radial displacement of the ring's bore after 1000 h: shaft 40 to 80.05, ring 80 to 160, interference 0.05."""
    a, b, radius, young, nu = 40.0, 80.05, 80.0, 2e5, 0.3
    # Lame: displacement of the shaft's surface per pressure on it; it has the force of the ring's bore on a longer circumference
    flexibility = (1 + nu)/young*b/(b*b - a*a)*((1 - 2*nu)*b*b + a*a)*radius/b
    ring = Ring(radius, 160.0, 1.8e5, nu, 1e-14, 5)
    # u(a) + flexibility p = 0.05, s_r(a) = -p
    return ring.run(1000.0, (-0.05/flexibility, 1/flexibility))[0][0]


def thick_cylinder():
    """Radial displacement of the bore after 100 h under a pressure of 200 MPa."""
    ring = Ring(100.0, 200.0, 2e5, 0.3, 3.125e-17, 5)
    return ring.run(100.0, (-200.0, 0.0))[0][0]


def pressed_blocks():
    """Force on 10 x 10 mm2 after 1000 h: heights 20 and 10, pressed by 0.02 and held."""
    compliance, creep, n = 20/2e5 + 10/1e5, 1e-14*20 + 2e-13*10, 4
    pressure = ((0.02/compliance)**(1 - n) + (n - 1)*creep/compliance*1000)**(-1/(n - 1))
    return -100*pressure


def main():
    cylinder = Ring(100.0, 200.0, 2e5, 0.3, 3.125e-17, 5)
    elastic = cylinder.solve([[0.0]*3 for _ in cylinder.r], (-200.0, 0.0))[1]
    steady = cylinder.run(1e4, (-200.0, 0.0))[1]
    k = 2**(2/5) - 1
    print(f"hoop stress at the bore: elastic {elastic[0][1]:.6f} (Lame {200*5/3:.6f}), "
          f"after 10 000 h {steady[0][1]:.6f} (steady {200/k*(1 - (1 - 2/5)*2**(2/5)):.6f})")
    print(f"shrink_fit {shrink_fit():.10g}\nthick_cylinder {thick_cylinder():.10g}\npressed_blocks {pressed_blocks():.10g}")


if __name__ == "__main__":
    main()
