"""Rubber by its hardness."""

# Gent, A.N., "On the relation between indentation hardness and Young's modulus", Rubber Chemistry and Technology
# 31 (1958) 896, doi 10.5254/1.3542351, in the form in which it is commonly quoted: MPa by degrees of Shore A. Of the
# paper itself only the abstract was read.


def young_modulus_pa(shore_a):
    """Young's modulus by Gent's relation [Pa]."""
    return 1e6 * 0.0981 * (56 + 7.62336 * shore_a) / (0.137505 * (254 - 2.54 * shore_a))


def shear_modulus_pa(shore_a):
    """A third of Young's modulus, as rubber hardly changes its volume [Pa]."""
    return young_modulus_pa(shore_a) / 3


# Ogden and Roxburgh (1999), doi 10.1098/rspa.1999.0431: r, m over the shear modulus, beta. The values are those of
# an example in the manual of Altair Radioss (2021, /FAIL/MULLINS_OR: R 2, beta 0.02, m 0.2 on a neo-Hookean rubber
# with a shear modulus of 1 MPa), not of a test of fender rubber.
SOFTENING = (2.0, 0.2, 0.02)

# Bulk over shear modulus. Rubber has 1000 to 2000; the reaction hardly knows it.
BULK_OVER_SHEAR = 1000.0

# Rubber on steel or concrete, assumed.
FRICTION = 0.3
