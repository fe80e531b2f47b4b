using System.Numerics;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Whoever saves, or sets to what was saved, what no public property of an object shows. The names stand in files and stay as they are.
/// </summary>
internal interface IHiddenFields
{
    void Value(string name, ref bool value);

    void Value(string name, ref int value);

    void Value(string name, ref float value);

    void Value(string name, ref double value);

    void Value(string name, ref Vector2 value);

    void Values(string name, ref float[] values);
}
