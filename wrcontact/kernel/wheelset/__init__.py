"""Both sides together: from pose and load to the outputs of a step."""
