"""What results of an evaluation are made of: which columns they hold, their names, and other forms of
them: dictionaries, text, HTML, tables of pandas and xarray."""
