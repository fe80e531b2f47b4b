using System.Numerics;

namespace FarseerGames.FarseerPhysics.Mathematics;

/// <summary>Converts between the units of the display (pixels) and those of the simulation, by one ratio for the program.</summary>
/// <remarks>
/// The simulation itself knows no units and never uses this class. The ratio is shared by the whole program; set it once at
/// the start, before other threads read it.
/// </remarks>
/// <example>
/// <code>
/// ConvertUnits.SetDisplayUnitToSimUnitRatio(64);
/// Vector2 onScreen = ConvertUnits.ToDisplayUnits(body.Position);
/// Vector2 inWorld = ConvertUnits.ToSimUnits(onScreen);
/// </code>
/// </example>
public static class ConvertUnits
{
    private static float _displayUnitsPerSimUnit = 50f;

    /// <summary>Sets the ratio.</summary>
    /// <param name="displayUnitsPerSimUnit">The number of display units in one unit of the simulation; above 0. Default 50.</param>
    /// <exception cref="System.ArgumentOutOfRangeException">The ratio is not a finite number above 0.</exception>
    public static void SetDisplayUnitToSimUnitRatio(float displayUnitsPerSimUnit) =>
        _displayUnitsPerSimUnit = Require.Positive(displayUnitsPerSimUnit, nameof(displayUnitsPerSimUnit));

    /// <summary>Converts a length to display units.</summary>
    /// <param name="simUnits">A length in units of the simulation.</param>
    /// <returns>The length in display units.</returns>
    public static float ToDisplayUnits(float simUnits) => simUnits * _displayUnitsPerSimUnit;

    /// <summary>Converts a length to display units.</summary>
    /// <param name="simUnits">A length in units of the simulation.</param>
    /// <returns>The length in display units.</returns>
    public static float ToDisplayUnits(int simUnits) => simUnits * _displayUnitsPerSimUnit;

    /// <summary>Converts a vector to display units.</summary>
    /// <param name="simUnits">A vector in units of the simulation.</param>
    /// <returns>The vector in display units.</returns>
    public static Vector2 ToDisplayUnits(Vector2 simUnits) => simUnits * _displayUnitsPerSimUnit;

    /// <summary>Converts a vector to display units.</summary>
    /// <param name="simUnits">A vector in units of the simulation; not changed.</param>
    /// <param name="displayUnits">The vector in display units.</param>
    public static void ToDisplayUnits(ref Vector2 simUnits, out Vector2 displayUnits) =>
        displayUnits = simUnits * _displayUnitsPerSimUnit;

    /// <summary>Converts a vector to display units.</summary>
    /// <param name="x">Its x coordinate, in units of the simulation.</param>
    /// <param name="y">Its y coordinate, in units of the simulation.</param>
    /// <returns>The vector in display units.</returns>
    public static Vector2 ToDisplayUnits(float x, float y) => new Vector2(x, y) * _displayUnitsPerSimUnit;

    /// <summary>Converts a vector to display units.</summary>
    /// <param name="x">Its x coordinate, in units of the simulation.</param>
    /// <param name="y">Its y coordinate, in units of the simulation.</param>
    /// <param name="displayUnits">The vector in display units.</param>
    public static void ToDisplayUnits(float x, float y, out Vector2 displayUnits) =>
        displayUnits = new Vector2(x, y) * _displayUnitsPerSimUnit;

    /// <summary>Converts a length to units of the simulation.</summary>
    /// <param name="displayUnits">A length in display units.</param>
    /// <returns>The length in units of the simulation.</returns>
    public static float ToSimUnits(float displayUnits) => displayUnits / _displayUnitsPerSimUnit;

    /// <summary>Converts a length to units of the simulation.</summary>
    /// <param name="displayUnits">A length in display units.</param>
    /// <returns>The length in units of the simulation.</returns>
    public static float ToSimUnits(double displayUnits) => (float)(displayUnits / _displayUnitsPerSimUnit);

    /// <summary>Converts a length to units of the simulation.</summary>
    /// <param name="displayUnits">A length in display units.</param>
    /// <returns>The length in units of the simulation.</returns>
    public static float ToSimUnits(int displayUnits) => displayUnits / _displayUnitsPerSimUnit;

    /// <summary>Converts a vector to units of the simulation.</summary>
    /// <param name="displayUnits">A vector in display units.</param>
    /// <returns>The vector in units of the simulation.</returns>
    public static Vector2 ToSimUnits(Vector2 displayUnits) => displayUnits / _displayUnitsPerSimUnit;

    /// <summary>Converts a vector to units of the simulation.</summary>
    /// <param name="displayUnits">A vector in display units; not changed.</param>
    /// <param name="simUnits">The vector in units of the simulation.</param>
    public static void ToSimUnits(ref Vector2 displayUnits, out Vector2 simUnits) =>
        simUnits = displayUnits / _displayUnitsPerSimUnit;

    /// <summary>Converts a vector to units of the simulation.</summary>
    /// <param name="x">Its x coordinate, in display units.</param>
    /// <param name="y">Its y coordinate, in display units.</param>
    /// <returns>The vector in units of the simulation.</returns>
    public static Vector2 ToSimUnits(float x, float y) => new Vector2(x, y) / _displayUnitsPerSimUnit;

    /// <summary>Converts a vector to units of the simulation.</summary>
    /// <param name="x">Its x coordinate, in display units.</param>
    /// <param name="y">Its y coordinate, in display units.</param>
    /// <returns>The vector in units of the simulation.</returns>
    public static Vector2 ToSimUnits(double x, double y) => new Vector2(ToSimUnits(x), ToSimUnits(y));

    /// <summary>Converts a vector to units of the simulation.</summary>
    /// <param name="x">Its x coordinate, in display units.</param>
    /// <param name="y">Its y coordinate, in display units.</param>
    /// <param name="simUnits">The vector in units of the simulation.</param>
    public static void ToSimUnits(float x, float y, out Vector2 simUnits) =>
        simUnits = new Vector2(x, y) / _displayUnitsPerSimUnit;
}
