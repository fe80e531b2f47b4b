namespace Box2D.Dynamics;

/// <content>Sleep.</content>
public partial class b2Body
{
    /// <summary>
    /// Whether the body sleeps: nothing moves it until a contact, a joint, a force or a call wakes it. Listeners hear nothing of contacts
    /// between sleeping bodies.
    /// </summary>
    /// <returns>True while it sleeps.</returns>
    public bool IsSleeping() => Link.IsSleeping;

    /// <summary>Lets the body sleep when it comes to rest, or forbids it and wakes it.</summary>
    /// <param name="flag">True allows it.</param>
    /// <exception cref="System.InvalidOperationException">The body is destroyed.</exception>
    public void AllowSleeping(bool flag)
    {
        CheckAlive();
        Link.AllowSleep(flag);
        if (!flag)
        {
            WakeUp();
        }
    }

    /// <summary>Wakes the body, and what hangs together with it by contacts and joints.</summary>
    public void WakeUp() => Link.WakeUp();

    /// <summary>Puts the body to sleep where it is; it stops.</summary>
    /// <exception cref="System.InvalidOperationException">The body is destroyed.</exception>
    public void PutToSleep()
    {
        CheckAlive();
        Link.PutToSleep();
    }
}
