"""The life cycle of a simulated wheelset, free of FMI."""
