# SPDX-License-Identifier: BSD-3-Clause
"""The paper's statements as a table: quote, measure, numbers, verdict, what the verdict depends on."""

import html

import scarp_report as scarp

BADGES = {"confirmed": True, "not confirmed": False}
ORDER = ("confirmed", "sensitive", "not confirmed", "not measured")


def draw(page, claims):
    """One line for each claim of results.json; the column of cases only where the claims name theirs."""
    counts = ", ".join(f"{sum(claim['verdict'] == verdict for claim in claims)} {verdict}" for verdict in ORDER)
    page.text(f"{len(claims)} statements: {counts}. “Sensitive” means that readings of what the paper leaves open (the "
              "cone of the plane runs or of all, preset, height, spacing) disagree. Numbers and verdict are those of the "
              "first reading; of the slopes in 3D, the same outer cone in 3D and 2D, whereas the pair printed in the "
              "paper is “2D by Eq. 11”. A reading with the same numbers shares the runs they come from and is no further "
              "support.")
    with_case = any("case" in claim for claim in claims)
    rows = []
    for number, claim in enumerate(claims, 1):
        badge = scarp.badge(BADGES.get(claim["verdict"]), claim["verdict"])
        rows.append([number] + ([claim.get("case", "")] if with_case else []) +
                    [claim["section"], claim["quote"], claim["measure"], claim["numbers"], badge,
                     scarp.Raw("<br>".join(map(html.escape, claim["sensitivity"].split(" | "))))])
    page.table(["", *(["case"] if with_case else []), "section", "the paper", "measure", "numbers", "verdict",
                "other readings"], rows)
