namespace Farseer.Samples.Terminal;

/// <summary>Colours of the 256-colour table, readable on black and on white.</summary>
internal static class Palette
{
    public const byte Text = 250;
    public const byte Dim = 243;
    public const byte Title = 220;
    public const byte Good = 71;
    public const byte Bad = 167;

    public const byte Static = 244;
    public const byte Driven = 178;
    public const byte Sensor = 170;
    public const byte Disabled = 239;
    public const byte Resting = 68;
    public const byte Touching = 71;
    public const byte Flying = 44;
    public const byte Contact = 203;
    public const byte Chosen = 214;
}
