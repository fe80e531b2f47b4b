namespace Farseer.Engine.Joints;

/// <summary>How long a substep is, and how much of a limit's overrun goes in it.</summary>
internal readonly struct LimitPace
{
    /// <summary>Share of an overrun of a limit that is taken away in a substep, if it is as long as any of late.</summary>
    private const double UsualRecovery = 0.2;

    /// <param name="substep">h, seconds.</param>
    /// <param name="errorScale">See <see cref="JointStep.ErrorScale"/>.</param>
    public LimitPace(double substep, double errorScale)
    {
        Substep = substep;
        Recovery = UsualRecovery * errorScale;
    }

    /// <summary>h, seconds.</summary>
    public double Substep { get; }

    /// <summary>The share of an overrun that goes.</summary>
    public double Recovery { get; }
}
