from math import log, pi

E, d, length, bearing, hole, force = 1.75e5, 24, 60, 36, 26, 1e5
area = pi*d**2/4
bolt = (length + 0.5*d + 0.5*d)/(E*area)
slope = 0.362 + 0.032*log(length/bearing/2) + 0.153*log(80/bearing)   # of the cone; 80: outer diameter of the plates
wide = bearing + length*slope                                         # its diameter, if the joint were at its other end
plates = 2*log((bearing + hole)*(wide - hole)/((bearing - hole)*(wide + hole)))/(E*pi*hole*slope)
interference = force*(bolt + plates)
print(f"interference {interference:.3f} mm")

A, n, start, t = 9.1e-26, 8, force/area, 1e5
stiffness = start*length/interference
stress = (start**(1 - n) + (n - 1)*A*stiffness*t)**(-1/(n - 1))
print(f"stress {start:.0f} MPa at the start, {stress:.0f} MPa after {t:.0f} h: {stress*area/1e3:.1f} kN")
