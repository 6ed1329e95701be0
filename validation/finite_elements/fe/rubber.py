"""Stiffness of rubber from its hardness."""

# Gent, A.N., "On the relation between indentation hardness and Young's modulus", Rubber Chemistry and Technology
# 31 (1958) 896, doi 10.5254/1.3542351, in the form in which it is commonly quoted: MPa by degrees of Shore A. Of the
# paper itself only the abstract was read.


def young_modulus_pa(shore_a):
    """Young's modulus by Gent's relation [Pa]."""
    return 1e6 * 0.0981 * (56 + 7.62336 * shore_a) / (0.137505 * (254 - 2.54 * shore_a))


def shear_modulus_pa(shore_a):
    """A third of Young's modulus, as rubber hardly changes its volume [Pa]."""
    return young_modulus_pa(shore_a) / 3


# Bulk over shear modulus. Rubber has 1000 to 2000; the reaction hardly depends on it.
BULK_OVER_SHEAR = 1000.0

# Rubber on steel or concrete, assumed.
FRICTION = 0.3
