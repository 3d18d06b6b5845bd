"""What weld_report.py and compare_report.py are made of: reading a folder, drawing it, writing the page."""
