"""How a master is kept with the rule that it breaks."""

NODE = 5
MASTERS = {}  # by name: rule, profile of the unit, master


def breaks(rule, profile='s120'):
    """Marks a master that breaks RULE and no other on a unit of PROFILE."""
    def keep(master):
        MASTERS[master.__name__] = (rule, profile, master)
        return master
    return keep
