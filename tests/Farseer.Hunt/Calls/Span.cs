namespace Farseer.Hunt.Calls;

/// <summary>
/// The numbers of a quantity: ordinary ones from <paramref name="Low"/> to <paramref name="High"/>, and the magnitudes that extremes
/// have.
/// </summary>
internal sealed record Span(float Low, float High, float Least, float Most)
{
    /// <summary>
    /// What is to be refused, or is at the end of what is not. Larger and smaller finite numbers than those of a quantity make forces
    /// that no float holds.
    /// </summary>
    private static readonly float[] _wild = { 0, float.NaN, float.PositiveInfinity, float.NegativeInfinity, -1 };

    public float Draw(Decoder decoder)
    {
        Choices choices = decoder.Choices;
        if (decoder.Profile != Profile.Extreme || choices.Below(4) != 0)
        {
            return choices.Between(Low, High);
        }

        if (choices.OneIn(8))
        {
            return _wild[choices.Below(_wild.Length)];
        }

        float magnitude = choices.OneIn(4) ? choices.Flag() ? Least : Most : choices.Between(Least, Most);
        return Low < 0 && choices.Flag() ? -magnitude : magnitude;
    }
}
