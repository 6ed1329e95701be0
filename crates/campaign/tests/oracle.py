"""The numbers of tests/oracle.rs, by SciPy: `python3 crates/campaign/tests/oracle.py` with SciPy 1.17 and NumPy.

Writes campaigns/berthing_speeds.csv (200 log-normal speeds, rounded) and prints the rows of the test.
"""

import pathlib

import numpy as np
from scipy import optimize, stats

campaigns = pathlib.Path(__file__).parents[3] / "campaigns"
x = np.round(np.random.default_rng(7).lognormal(np.log(6.0), 0.55, 200), 2)
(campaigns / "berthing_speeds.csv").write_text("speed [cm/s]\n" + "".join(f"{v}\n" for v in x), encoding="utf-8")

print("clopper_pearson")
for k, n in [(0, 50), (1, 50), (3, 1_000_000), (50, 50), (25, 50), (700, 1500), (1000, 1_000_000), (400_000, 1_000_000)]:
    ci = stats.binomtest(k, n).proportion_ci(0.95, method="exact")
    print(f"    ({k}, {n}, {ci.low!r}, {ci.high!r}),".replace("np.float64(", "").replace(")", "", 0))


def polished(nll, start):
    best = optimize.minimize(nll, start, method="Nelder-Mead", options=dict(xatol=1e-12, fatol=1e-13, maxiter=20000, maxfev=40000))
    return best.x, -best.fun


laws = {
    "Normal": (lambda p: -stats.norm.logpdf(x, p[0], p[1]).sum(), [7, 4]),
    "LogNormal": (lambda p: -stats.lognorm.logpdf(x, p[1], 0, np.exp(p[0])).sum(), [1.8, 0.5]),
    "Weibull": (lambda p: -stats.weibull_min.logpdf(x, p[0], 0, p[1]).sum(), [1.7, 8]),
    "Gumbel": (lambda p: -stats.gumbel_r.logpdf(x, p[0], p[1]).sum(), [5, 3]),
    "Gev": (lambda p: -stats.genextreme.logpdf(x, -p[2], p[0], p[1]).sum(), [5, 3, 0.1]),
}
frozen = {
    "Normal": lambda p: stats.norm(p[0], p[1]),
    "LogNormal": lambda p: stats.lognorm(p[1], 0, np.exp(p[0])),
    "Weibull": lambda p: stats.weibull_min(p[0], 0, p[1]),
    "Gumbel": lambda p: stats.gumbel_r(p[0], p[1]),
    "Gev": lambda p: stats.genextreme(-p[2], p[0], p[1]),
}


def anderson(values, law):
    s = np.sort(values)
    n = len(s)
    i = np.arange(1, n + 1)
    return -n - np.sum((2 * i - 1) * (law.logcdf(s) + law.logsf(s[::-1]))) / n


def row(name, params, loglik, values, law, at):
    d = stats.kstest(values, law.cdf).statistic
    shown = [float(p) for p in params]
    print(f"    (Law::{name}, &{shown}, {loglik:.9f}, {d:.12f}, {anderson(values, law):.9f}, {at:.9f}),")


print("fits")
for name, (nll, start) in laws.items():
    params, loglik = polished(nll, start)
    law = frozen[name](params)
    row(name, params, loglik, x, law, law.isf(1 / 3000))
u = 8.0
y = x[x > u] - u
params, loglik = polished(lambda p: -stats.genpareto.logpdf(y, p[1], 0, p[0]).sum(), [3, 0.1])
law = stats.genpareto(params[1], 0, params[0])
row("Pareto", [u, *params], loglik, y, law, u + law.isf(1 / 3000 / (len(y) / len(x))))

a = np.array([1, 2, 4, 8, 16, 5.0])
print("moments", [float(v) for v in (np.mean(a), np.std(a, ddof=1), stats.skew(a), stats.sem(a))])
print("spearman", float(stats.spearmanr([1, 2, 2, 4, 5, 6, 7, 7], [2, 1, 4, 3, 7, 5, 8, 6]).statistic))
