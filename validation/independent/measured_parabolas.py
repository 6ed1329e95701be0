"""Parabolas through measured readings by statsmodels and SciPy, for the tests of crates/measured.

Run `python3 validation/independent/measured_parabolas.py > crates/measured/tests/parabolas.json` in an environment with
numpy, scipy and statsmodels (`pip install scipy statsmodels`). The smoothing of `fenderline berthings` is ordinary least
squares; statsmodels gives its coefficients, their covariance and the deviation, and SciPy's filter of Savitzky and Golay
gives value and slope at the last of evenly spaced readings.
"""

import json

import numpy as np
import statsmodels.api as sm
from scipy.signal import savgol_coeffs


def by_statsmodels(t_s, y, at_s):
    u = t_s - at_s
    fit = sm.OLS(y, np.column_stack([np.ones_like(u), u, u * u])).fit()
    off = fit.resid
    return {
        "of": fit.params.tolist(),
        "covariance": fit.cov_params().tolist(),
        "deviation": float(np.sqrt(fit.scale)),
        "correlation": float(off[1:] @ off[:-1] / (off @ off)),
    }


def main():
    random = np.random.default_rng(40)
    cases = []
    for count, step_s, sd in [(30, 1.0, 0.01), (12, 10.0, 0.5), (50, 0.2, 0.003), (8, 4.0, 0.02)]:
        even = step_s * np.arange(count)
        for t_s in [even, np.sort(even + random.uniform(-0.4, 0.4, count) * step_s)]:
            at_s = float(t_s[-1] + random.uniform(0.0, 0.5) * step_s)
            u = t_s - at_s
            y = 0.3 - 0.12 * u + 2e-4 * u * u + sd * random.standard_normal(count)
            case = {"t_s": t_s.tolist(), "y": y.tolist(), "at_s": at_s, "by_statsmodels": by_statsmodels(t_s, y, at_s)}
            if t_s is even:
                # Coefficients are in the order of a convolution: of the last reading first.
                ends = [
                    float(savgol_coeffs(count, 2, deriv=deriv, delta=step_s, pos=count - 1, use="dot") @ y)
                    for deriv in (0, 1)
                ]
                case["by_savitzky_golay"] = ends
            cases.append(case)
    print(json.dumps(cases, indent=1))


if __name__ == "__main__":
    main()
