bore, fit, rim = 30, 60, 100
E_shaft, E_ring, nu = 1.70e5, 1.65e5, 0.3
interference = 0.1 + (1.36e-5 - 1.42e-5)*(500 - 20)*fit
shaft = ((fit**2 + bore**2)/(fit**2 - bore**2) - nu)/E_shaft
ring = ((rim**2 + fit**2)/(rim**2 - fit**2) + nu)/E_ring
print(f"interference {interference:.4f} mm, pressure {interference/fit/(shaft + ring):.2f} MPa")
