"""What an unknown word was meant to be."""

#: How alike a word and a known one are at least, from 0 to 1.
ALIKE = 0.6
#: Known words that are proposed at most.
MOST = 3

#: How a proposal begins.
PROPOSAL = "; did you mean "


def did_you_mean(word, known):
    """A proposal behind a sentence on an unknown ``word``: "; did you mean left_friction or right_friction?".

    The ``known`` words that contain it are proposed, else those that are spelled like it, in any case;
    "" where there are none.

    >>> did_you_mean("friction", ["yaw", "left_friction", "right_friction"])
    '; did you mean left_friction or right_friction?'
    >>> did_you_mean("yaw_angel", ["yaw_angle", "speed"]), did_you_mean("x", ["yaw", "speed"])
    ('; did you mean yaw_angle?', '')
    """
    from difflib import get_close_matches  # not needed before somebody errs

    if not isinstance(word, str):
        return ""
    by_letters = {name.lower(): name for name in known}
    found = [letters for letters in by_letters if word.lower() in letters and len(word) > 2][:MOST]
    found = found or get_close_matches(word.lower(), by_letters, 1, ALIKE)
    return f"{PROPOSAL}{' or '.join(by_letters[letters] for letters in found)}?" if found else ""
