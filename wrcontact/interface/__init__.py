"""The border of the model: the one table of variables and the life cycle of a simulated wheelset."""
