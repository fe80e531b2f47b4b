namespace Box2D.Dynamics;

/// <content>Sleep.</content>
public partial class b2Body
{
    private bool _allowSleep = true;

    /// <summary>Whether the body sleeps: it is not simulated until something wakes it.</summary>
    /// <returns>True while it sleeps.</returns>
    public bool IsSleeping() => false;

    /// <summary>Lets the body sleep when it comes to rest, or forbids it and wakes it.</summary>
    /// <param name="flag">True allows it.</param>
    public void AllowSleeping(bool flag)
    {
        _allowSleep = flag;
        if (!flag)
        {
            WakeUp();
        }
    }

    /// <summary>Wakes the body.</summary>
    public void WakeUp()
    {
    }

    /// <summary>Puts the body to sleep where it is; it stops.</summary>
    public void PutToSleep()
    {
        Link.Velocity = default;
        Link.Spin = 0;
    }

    internal bool MaySleep => _allowSleep;
}
