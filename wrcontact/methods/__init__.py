"""The methods that a system can be built with."""
